// Markdown as far as it has to be known to leave code alone.

const CODE = /^(`{3,}|~{3,})[^\n]*\n[\s\S]*?^\1[^\n]*$|(`+)(?!`)(?:(?!\n\s*\n)[\s\S])*?(?<!`)\2(?!`)/gm;

/** The text with `change` made in all but blocks and spans of code. */
export function outsideCode(text, change) {
  let result = "";
  let from = 0;
  for (const code of text.matchAll(CODE)) {
    result += change(text.slice(from, code.index)) + code[0];
    from = code.index + code[0].length;
  }
  return result + change(text.slice(from));
}

/** A text as it stands in HTML that Markdown is not to touch: what either would take for a sign of its own is written by number. */
export function escaped(text) {
  return text.replace(/[&<>"'\\`*_{}[\]()#+\-.!|~$]/g, (sign) => `&#${sign.codePointAt(0)};`);
}
