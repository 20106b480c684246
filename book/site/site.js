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
