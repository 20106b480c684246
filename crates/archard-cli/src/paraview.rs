//! `archard paraview`: the worn surfaces of a result folder as geometry in mm with point data, and a macro that opens them well
//! framed.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use archard::body::Body;
use archard_case::output::{
    Collection, Error, Field, Image, Manifest, RELIEF, Sheet, Surface, WornSurface, bodies,
};

use crate::failure::Failure;
use crate::say::say;

/// The folder of the files, and the macro in it.
const FOLDER: &str = "paraview";
const MACRO: &str = "open.py";
/// How high the relief stands, relative to how wide the surface is, once it is exaggerated.
const HEIGHT: f64 = 0.15;

/// Writes the files of a result folder.
pub fn write(dir: &Path) -> Result<(), Failure> {
    let wrong = |error: Error| Failure::wrong(error.to_string());
    // A body by itself has no contact to show.
    let alone = dir.join("surface.vtu").exists() && !dir.join("fields.pvd").exists();
    let read =
        if alone { Ok(Collection::default()) } else { Collection::read(&dir.join("fields.pvd")) };
    let collection = read.map_err(|error| {
        Failure::wrong(format!(
            "{error}; `archard paraview` wants a folder that `archard run` has written"
        ))
    })?;
    let folder = dir.join(FOLDER);
    if folder.is_symlink() {
        let message = format!("`{}` is a link, through which nothing is written", folder.display());
        return Err(Failure::wrong(message));
    }
    let mut manifest = Manifest::read(&folder).map_err(wrong)?;
    manifest.begin([]).map_err(wrong)?;
    let mut written: BTreeMap<usize, (String, Collection, [f64; 4])> = BTreeMap::new();
    for (index, (progress, file)) in collection.outputs.iter().enumerate() {
        for (place, (body, surface)) in
            surfaces(&dir.join(file)).map_err(wrong)?.into_iter().enumerate()
        {
            let name = format!("{body}_{index:04}.vtu");
            surface.write(&manifest.claim(&name).map_err(wrong)?).map_err(wrong)?;
            let found = extents(&surface);
            let entry =
                written.entry(place).or_insert_with(|| (body, Collection::default(), [0.0; 4]));
            entry.1.outputs.push((*progress, name));
            entry.2 = [0, 1, 2, 3].map(|which| entry.2[which].max(found[which]));
        }
    }
    let names: Vec<&str> = written.values().map(|body| body.0.as_str()).collect();
    let inside = bodies_inside(dir, &mut manifest, &names).map_err(wrong)?;
    if alone {
        let files = inside.join(" and ");
        return say(&format!("{files} written into {}; open them in ParaView", folder.display()));
    }
    for (body, collection, _) in written.values() {
        let path = manifest.claim(&format!("{body}.pvd")).map_err(wrong)?;
        collection.write(&path).map_err(wrong)?;
    }
    let most = |which: usize| written.values().map(|body| body.2[which]).fold(0.0, f64::max);
    let shown = if most(2) > 0.0 { (SHOWN[0], most(2)) } else { (SHOWN[1], most(3)) };
    let script = script(&names, most(0), factor(most(0), most(1)), shown);
    let path = manifest.write(MACRO, script.as_bytes()).map_err(wrong)?;
    let beside = if inside.is_empty() { String::new() } else { format!(", {}", inside.join(", ")) };
    say(&format!(
        "{} outputs of {}{beside} written into {}; next: paraview --script={}",
        collection.outputs.len(),
        names.join(" and "),
        folder.display(),
        path.display()
    ))
}

/// Writes what loads make of meshed bodies, on their surfaces and on sections; the names of the files.
fn bodies_inside(
    dir: &Path,
    manifest: &mut Manifest,
    bodies: &[&str],
) -> Result<Vec<String>, Error> {
    let mut written = vec![];
    let mut write = |surface: &WornSurface, name: String| -> Result<(), Error> {
        surface.write(&manifest.claim(&name)?)?;
        written.push(name);
        Ok(())
    };
    let surfaces = [("surface.vtu", None), ("surface_1.vtu", Some(0)), ("surface_2.vtu", Some(1))];
    for (file, which) in surfaces.into_iter().filter(|(file, _)| dir.join(file).exists()) {
        let body = which.and_then(|which: usize| bodies.get(which)).unwrap_or(&"body");
        let surface = Surface::read(&dir.join(file))?;
        write(&WornSurface::of_body(&surface), format!("stress_{body}.vtu"))?;
    }
    let sections = fs::read_dir(dir.join("sections")).into_iter().flatten().flatten();
    let mut sections: Vec<_> = sections.map(|entry| entry.path()).collect();
    sections.sort();
    for path in sections.iter().filter(|path| path.extension().is_some_and(|end| end == "vtu")) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        write(&WornSurface::of_sheet(&Sheet::read(path)?), format!("section_{name}"))?;
    }
    Ok(written)
}

/// The surfaces of both bodies at an output, body 1 first.
fn surfaces(path: &Path) -> Result<Vec<(String, WornSurface)>, Error> {
    let meshed = path.extension().is_some_and(|extension| extension == "vtu");
    let of = |fields: &[Field], make: &dyn Fn(&str) -> Option<WornSurface>| {
        let bodies = bodies(fields);
        if let Some(name) = bodies.iter().find(|body| !Body::is_name(body)) {
            let what = format!("no case can have a body `{name}`");
            return Err(Error::NotAnImage { path: path.to_owned(), what });
        }
        let named = |body: &&str| Some(((*body).to_owned(), make(body)?));
        Ok(bodies.iter().filter_map(named).collect())
    };
    if meshed {
        let surface = Surface::read(path)?;
        of(&surface.fields, &|body| WornSurface::of_surface(&surface, body))
    } else {
        let image = Image::read(path)?;
        of(&image.fields, &|body| WornSurface::of_image(&image, body))
    }
}

/// What the surfaces are coloured by, where nothing has worn the second.
const SHOWN: [&str; 2] = ["wear_um", "pressure_MPa"];

/// How wide a surface is (mm), how much its relief differs (mm), and the most of what it may be coloured by.
fn extents(surface: &WornSurface) -> [f64; 4] {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        (high - low).max(0.0)
    };
    let width = [0, 1].map(|axis| range(&mut surface.points.iter().map(|point| point[axis])));
    let relief = surface.vectors.iter().find(|(name, _)| name == RELIEF);
    let relief = relief.map_or(0.0, |(_, vectors)| {
        [0, 1, 2]
            .map(|axis| range(&mut vectors.iter().map(|vector| vector[axis])))
            .into_iter()
            .fold(0.0, f64::max)
    });
    let [wear, pressure] = SHOWN.map(|name| {
        let field = surface.fields.iter().find(|field| field.name == name);
        field.map_or(0.0, |field| field.values.iter().copied().fold(0.0, f64::max))
    });
    [width[0].max(width[1]), relief, wear, pressure]
}

/// How many times as high the relief is drawn: one, two or five times a power of ten, one at least.
fn factor(width: f64, relief: f64) -> f64 {
    let wanted = HEIGHT * width / relief;
    if !wanted.is_finite() || wanted <= 1.0 {
        return 1.0;
    }
    let power = 10f64.powf(wanted.log10().floor());
    let step = [5.0, 2.0, 1.0].into_iter().find(|step| step * power <= wanted);
    step.unwrap_or(1.0) * power
}

/// The macro, for these bodies in that width (mm), with the relief that many times as high.
fn script(bodies: &[&str], width: f64, factor: f64, (shown, most): (&str, f64)) -> String {
    format!(
        r#"# Shows the worn surfaces beside this file: paraview --script=open.py, or Macros > Import new macro in ParaView.
# Lengths are in mm. Heights are drawn {factor} times as high; the second body is lifted off the first.
import os

from paraview.simple import *

try:
    here = os.path.dirname(os.path.abspath(__file__))
except NameError:
    here = os.getcwd()
bodies = {bodies:?}
view = GetActiveViewOrCreate("RenderView")
for index, body in enumerate(bodies):
    reader = PVDReader(FileName=os.path.join(here, body + ".pvd"), registrationName=body)
    times = reader.TimestepValues
    relief = WarpByVector(Input=reader, registrationName=body + " x {factor}")
    relief.Vectors = ["POINTS", "{RELIEF}"]
    relief.ScaleFactor = {} * 1.0
    display = Show(relief, view)
    display.Position = [0.0, 0.0, {lift:?} * index]
    ColorBy(display, ("POINTS", "{shown}"))
    Hide(reader, view)
animation = GetAnimationScene()
animation.UpdateAnimationUsingDataTimeSteps()
animation.GoToLast()
colours = GetColorTransferFunction("{shown}")
colours.RescaleTransferFunction(0.0, {most:?})
bar = GetScalarBar(colours, view)
bar.Title = "{shown}"
bar.ComponentTitle = ""
bar.Visibility = 1
view.ViewSize = [1200, 800]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.CameraPosition = [-2.0, -3.0, 2.0]
view.CameraFocalPoint = [0.0, 0.0, 0.0]
view.ResetCamera()
Render(view)
"#,
        factor - 1.0,
        lift = 0.4 * width,
    )
}

#[cfg(test)]
mod tests {
    use super::factor;

    #[test]
    fn reliefs_are_drawn_in_round_multiples() {
        for (width, relief, expected) in
            [(1.0, 1e-3, 100.0), (1.0, 0.5, 1.0), (0.5, 2e-3, 20.0), (1.0, 0.0, 1.0)]
        {
            assert_eq!(factor(width, relief), expected, "{width} {relief}");
        }
    }
}
