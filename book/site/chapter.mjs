// A page that is not in the book's folder, as mdBook takes it.

/** A chapter at `path` below a chapter of the book; its name is its first heading. */
export function chapter(content, path, parent) {
  const name = /^# (.*)$/m.exec(content)?.[1];
  if (!name) {
    throw new Error(`${path}: the page has no heading to be named by: begin it with "# "`);
  }
  return {
    name: name.replaceAll("`", ""),
    content,
    number: null,
    sub_items: [],
    path,
    source_path: null,
    parent_names: [parent.name],
  };
}
