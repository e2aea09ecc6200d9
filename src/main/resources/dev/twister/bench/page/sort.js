// Sorts a table by the column whose heading is clicked; a second click reverses it. Empty cells stay last.
for (const button of document.querySelectorAll("table.sortable th button")) {
  button.addEventListener("click", () => {
    const heading = button.parentElement;
    const column = [...heading.parentElement.children].indexOf(heading);
    const up = heading.getAttribute("aria-sort") !== "ascending";
    for (const other of heading.parentElement.children) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", up ? "ascending" : "descending");
    const body = heading.closest("table").tBodies[0];
    const text = (row) => row.cells[column].textContent;
    const order = (a, b) => text(a).localeCompare(text(b), "en", { numeric: true });
    const rows = [...body.rows].sort((a, b) =>
      text(a) === "" || text(b) === "" ? (text(a) === "") - (text(b) === "") : up ? order(a, b) : order(b, a));
    body.append(...rows);
  });
}
