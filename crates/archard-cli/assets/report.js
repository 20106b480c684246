"use strict";
// Unpacks the numbers of this page and plotly.js, and draws. Nothing is fetched.
(async () => {
  const trouble = (words) => {
    const place = document.getElementById("trouble");
    place.textContent = words;
    place.hidden = false;
    document.body.dataset.state = "trouble";
  };
  const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const unpack = async (id) => {
    const packed = new Blob([bytes(document.getElementById(id).textContent)]);
    return new Response(packed.stream().pipeThrough(new DecompressionStream("gzip"))).text();
  };
  if (!("DecompressionStream" in window)) {
    trouble("This browser is too old for the pictures of this page; words and tables are complete.");
    return;
  }
  const [library, text] = await Promise.all([unpack("plotly"), unpack("data")]);
  const script = document.createElement("script");
  script.textContent = library;
  document.documentElement.classList.add("draws");
  document.head.append(script);
  // Plotly reads a few tags in its words; those of a folder are words alone.
  const tame = (value) => {
    if (typeof value === "string") return value.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
    if (Array.isArray(value)) return value.map(tame);
    if (value === null || typeof value !== "object") return value;
    return Object.fromEntries(Object.entries(value).map(([key, own]) => [key, tame(own)]));
  };
  const { figures: untamed, maps, mark } = JSON.parse(text);
  const figures = tame(untamed);

  const ink = "#1a1a1a";
  const config = { responsive: true, displaylogo: false, displayModeBar: "hover",
    modeBarButtonsToRemove: ["lasso2d", "select2d", "autoScale2d"] };
  const frame = { showline: true, mirror: true, linecolor: ink, ticks: "outside", gridcolor: "#e4e4e4",
    zeroline: false, automargin: true, exponentformat: "power" };
  const noted = (layout) => {
    if (mark) {
      layout.annotations = (layout.annotations || []).concat({ text: tame(mark.replace(/(.{1,70})( |$)/g, "$1\n")).replaceAll("\n", "<br>"),
        xref: "paper", yref: "paper", x: 0, y: 1, xanchor: "left", yanchor: "bottom", align: "left",
        showarrow: false, font: { color: "#8c1c00", size: 11 } });
    }
    return layout;
  };
  // The legend stands at the bottom of the figure, below the label of the axis.
  const styled = (layout) => noted({
    ...layout,
    font: { family: "system-ui, 'Segoe UI', Roboto, 'Liberation Sans', sans-serif", size: 13, color: ink },
    margin: { l: 56, r: 16, t: mark ? 48 : 34, b: 44 },
    separators: ".\u2009",
    xaxis: { ...frame, ...layout.xaxis },
    yaxis: { ...frame, ...layout.yaxis },
    legend: { orientation: "h", x: 0, xanchor: "left", yref: "container", y: 0, yanchor: "bottom", ...layout.legend },
  });
  // What is drawn takes the place of the picture on the screen.
  const overlay = (place) => {
    place.parentElement.classList.add("drawn");
    return place;
  };
  // The picture in print is of what was drawn last.
  const printed = async (place) => {
    if (!place._fullLayout) return;
    let picture = place.parentElement.querySelector("img.still");
    if (!picture) {
      picture = document.createElement("img");
      picture.className = "still";
      picture.alt = place.getAttribute("aria-label");
      place.after(picture);
    }
    picture.src = await Plotly.toImage(place, { format: "png", width: 720, height: 430 });
  };

  for (let i = 0; i < figures.length; i += 1) {
    const place = overlay(document.getElementById(`figure-${i + 1}`));
    await Plotly.newPlot(place, figures[i].data, styled(figures[i].layout), config);
  }
  if (maps) await mapped();
  document.body.dataset.state = "done";

  async function mapped() {
    const { x, y, across, outputs, bodies, fields } = maps;
    // Of meshed bodies values are those of elements, and each place shows one of them.
    const shown = maps.shown && new Int32Array(bytes(maps.shown).buffer);
    const rows = (values) => y.map((_, row) => Array.from(values.subarray(row * x.length, (row + 1) * x.length)));
    const values = (name, output) => {
      const { step } = fields[name];
      // Beside the frame of its time an output has no values.
      const value = (whole) => (whole === -32768 ? NaN : whole * step);
      const raw = new Int16Array(bytes(fields[name].outputs[output]).buffer);
      return shown ? Float64Array.from(shown, (part) => (part < 0 ? 0 : value(raw[part]))) : Float64Array.from(raw, value);
    };
    const top = (list) => list.reduce((most, value) => (Math.abs(value) > most ? Math.abs(value) : most), 0);
    const largest = (name) => Math.max(...outputs.map((_, output) => top(values(name, output))));
    // Where there is nothing the map is white; between centres of elements it is interpolated.
    const colours = [[0, "#ffffff"], [0.02, "#440154"], [0.25, "#3b528b"], [0.5, "#21918c"], [0.75, "#5ec962"], [1, "#fde725"]];
    const length = (ends) => Math.abs(ends[ends.length - 1] - ends[0]);
    const slender = Math.max(length(x), length(y)) > 4 * Math.min(length(x), length(y));
    // The whole of the elements, whichever of them show something.
    const range = (places) => {
      const half = length(places) / Math.max(1, places.length - 1) / 2;
      return half > 0 ? [Math.min(...places) - half, Math.max(...places) + half] : undefined;
    };
    const plane = () => styled({
      xaxis: { title: { text: `x (${across})` }, range: range(x), constrain: "domain", showgrid: false },
      yaxis: { title: { text: `y (${across})` }, range: range(y), constrain: "domain", showgrid: false, ...(slender ? {} : { scaleanchor: "x" }) },
    });
    const heat = (name, title, output) => ({ type: "heatmap", x, y, z: rows(values(name, output)), zsmooth: "best", colorscale: colours,
      zmin: 0, zmax: top(values(name, output)) || 1, colorbar: { title: { text: `${title} (${fields[name].unit})`, side: "right" }, thickness: 14 },
      hovertemplate: `x %{x} ${across}<br>y %{y} ${across}<br>%{z:.4g} ${fields[name].unit}<extra></extra>` });
    // Tractions as arrows on a coarser grid, the longest as long as its cells.
    const arrows = (output) => {
      const [tx, ty] = ["x", "y"].map((axis) => values(`traction_${axis}_Pa`, output));
      const every = [x.length, y.length].map((count) => Math.max(1, Math.round(count / 13)));
      const size = [x, y].map((ends, axis) => (length(ends) / Math.max(1, ends.length - 1)) * every[axis]);
      let most = 0;
      for (let i = 0; i < tx.length; i += 1) most = Math.max(most, Math.hypot(tx[i], ty[i]));
      const line = { x: [], y: [] };
      if (most === 0) return line;
      const scale = slender ? [size[0], size[1]] : [Math.min(...size), Math.min(...size)];
      for (let row = Math.floor(every[1] / 2); row < y.length; row += every[1]) {
        for (let column = Math.floor(every[0] / 2); column < x.length; column += every[0]) {
          const place = row * x.length + column;
          const share = Math.hypot(tx[place], ty[place]) / most;
          if (share < 0.02) continue;
          const [ux, uy] = [tx[place] / most, ty[place] / most];
          const at = (along, beside) => [x[column] + scale[0] * (along * ux - beside * uy), y[row] + scale[1] * (along * uy + beside * ux)];
          for (const [along, beside] of [[-0.45, 0], [0.45, 0], [0.2, 0.16], [0.45, 0], [0.2, -0.16]]) {
            const [px, py] = at(along, beside);
            line.x.push(px);
            line.y.push(py);
          }
          line.x.push(null);
          line.y.push(null);
        }
      }
      return line;
    };
    const pressure = (output) => {
      const traces = [heat("pressure_Pa", "Pressure", output)];
      if (fields.stick) {
        const stick = rows(values("stick", output));
        if (stick.some((row) => row.some((value) => value > 0))) {
          traces.push({ type: "contour", x, y, z: stick, showscale: false, hoverinfo: "skip", autocontour: false, name: "stick",
            contours: { start: 0.5, end: 0.5, size: 1, coloring: "none" }, line: { color: "#d55e00", width: 2.5 } });
        }
      }
      if (fields.traction_x_Pa && fields.traction_y_Pa) {
        traces.push({ type: "scatter", mode: "lines", ...arrows(output), line: { color: "#ffffff", width: 3 }, hoverinfo: "skip", showlegend: false });
        traces.push({ type: "scatter", mode: "lines", ...arrows(output), line: { color: ink, width: 1.4 }, hoverinfo: "skip", showlegend: false });
      }
      return traces;
    };
    const webgl = () => {
      try { return !!document.createElement("canvas").getContext("webgl"); } catch (error) { return false; }
    };
    const solid = webgl();
    const views = { tilted: { x: 1.25, y: -1.35, z: 0.95 }, above: { x: 0, y: -0.01, z: 2.1 }, side: { x: 0, y: -2.1, z: 0.15 } };
    // Body 1 is shown above, as it stands on body 2; the files have it below.
    const surface = (output) => {
      const body = Number(document.getElementById("body").value);
      const [height, wear] = [`height_${bodies[body]}_m`, `wear_${bodies[body]}_m`];
      const unit = fields[height].unit;
      const z = rows(values(height, output).map((value) => -value));
      const coloured = fields[wear] && largest(wear) > 0;
      return [{ type: "surface", x, y, z, colorscale: "Viridis", showscale: Boolean(coloured),
        surfacecolor: coloured ? rows(values(wear, output)) : z, cmin: coloured ? 0 : undefined, cmax: coloured ? largest(wear) : undefined,
        colorbar: coloured ? { title: { text: `Wear (${fields[wear].unit})`, side: "right" }, thickness: 14 } : undefined,
        hovertemplate: `x %{x} ${across}<br>y %{y} ${across}<br>height %{z:.4g} ${unit}<extra>${tame(bodies[body])}</extra>` }];
    };
    const space = () => {
      const body = Number(document.getElementById("body").value);
      const height = fields[`height_${bodies[body]}_m`];
      const sides = [length(x), length(y)].map((side) => Math.max(0.35, side / Math.max(length(x), length(y))));
      return noted({
        font: styled({}).font,
        margin: { l: 0, r: 0, t: mark ? 44 : 10, b: 0 },
        uirevision: "turned",
        scene: { aspectmode: "manual", aspectratio: { x: 1.2 * sides[0], y: 1.2 * sides[1], z: 0.45 }, camera: { eye: views.tilted },
          xaxis: { title: { text: `x (${across})` } }, yaxis: { title: { text: `y (${across})` } }, zaxis: { title: { text: `height (${height.unit})` } } },
      });
    };
    const slider = document.getElementById("output");
    const draw = async () => {
      const output = Number(slider.value);
      slider.setAttribute("aria-valuetext", outputs[output]);
      document.getElementById("output-label").textContent = outputs[output];
      await Plotly.react(overlay(document.getElementById("map-pressure")), pressure(output), plane(), config);
      for (let body = 0; body < bodies.length; body += 1) {
        const place = document.getElementById(`map-wear-${body}`);
        if (place) {
          await Plotly.react(overlay(place), [heat(`wear_${bodies[body]}_m`, "Wear", output)], plane(), config);
        }
      }
      if (solid) {
        await Plotly.react("surface", surface(output), space(), config);
      }
      document.body.dataset.output = String(output);
    };
    if (!solid) {
      document.getElementById("surface").textContent = "This browser draws no surfaces in space (WebGL is off); the maps show the same depths.";
    }
    await draw();
    if (solid) await printed(document.getElementById("surface"));
    // One drawing at a time: the last place of the slider counts.
    let busy = false;
    let again = false;
    const follow = async () => {
      again = true;
      if (busy) return;
      busy = true;
      while (again) {
        again = false;
        await draw();
      }
      busy = false;
      clearTimeout(follow.later);
      follow.later = setTimeout(() => document.querySelectorAll(".plot.map").forEach(printed), 400);
    };
    slider.addEventListener("input", follow);
    document.getElementById("body").addEventListener("change", follow);
    for (const button of document.querySelectorAll("button[data-view]")) {
      button.addEventListener("click", () => solid && Plotly.relayout("surface", { "scene.camera.eye": views[button.dataset.view] }));
    }
    // By the arrow keys too: about the vertical in steps of 10 degrees, and up and down.
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const turned = document.getElementById("surface");
    turned.tabIndex = 0;
    turned.addEventListener("keydown", (event) => {
      const turn = turns[event.key];
      if (!turn || !solid) return;
      event.preventDefault();
      const { x, y, z } = turned._fullLayout.scene.camera.eye;
      const step = Math.PI / 18;
      const across = Math.atan2(y, x) + turn[0] * step;
      const far = Math.hypot(x, y, z);
      const up = Math.min(Math.max(Math.asin(z / far) + turn[1] * step, -1.5), 1.5);
      const eye = { x: far * Math.cos(up) * Math.cos(across), y: far * Math.cos(up) * Math.sin(across), z: far * Math.sin(up) };
      Plotly.relayout("surface", { "scene.camera.eye": eye });
    });
  }
})().catch((error) => {
  console.error(error);
  document.body.dataset.state = "trouble";
  const place = document.getElementById("trouble");
  place.textContent = `The pictures could not be drawn: ${error}`;
  place.hidden = false;
});
