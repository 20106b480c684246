// What scrolls by itself can be reached by the keyboard.

const SCROLLING = ".table-wrapper, .content pre > code, .katex-display";

function letScroll() {
  for (const part of document.querySelectorAll(SCROLLING)) {
    if (part.scrollWidth > part.clientWidth) {
      part.tabIndex = 0;
    } else {
      part.removeAttribute("tabindex");
    }
  }
}

window.addEventListener("load", letScroll);
window.addEventListener("resize", letScroll);

// The button of the contents is a label, which keys do not press.
document.getElementById("mdbook-sidebar-toggle").addEventListener("keydown", (event) => {
  if (event.key === "Enter" || event.key === " ") {
    event.preventDefault();
    event.currentTarget.click();
  }
});

// The bar at the side is scrolled to the page that is shown, and browsers start the keyboard there: it starts at the top, where the link past
// the navigation is.
window.addEventListener("load", () => {
  if (document.activeElement !== document.body || location.hash) return;
  document.body.tabIndex = -1;
  document.body.focus({ preventScroll: true });
  document.body.removeAttribute("tabindex");
});
