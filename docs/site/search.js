// On a narrow screen the lists begin closed, so that the page itself is seen.
if (matchMedia("(max-width: 52rem)").matches) {
  document.querySelectorAll("nav details").forEach((list) => { list.open = false; });
}

// Lists the pages that have all the words that are typed, those that have them in their title first.
const field = document.getElementById("search");
const found = document.getElementById("found");
field.addEventListener("input", () => {
  const words = field.value.toLowerCase().split(/\s+/).filter((word) => word);
  const hits = words.length === 0 ? [] : pages
    .map(([address, title, text]) => ({ address, title, text, all: (title + " " + text).toLowerCase() }))
    .filter(({ all }) => words.every((word) => all.includes(word)))
    .sort((a, b) => rank(b, words) - rank(a, words));
  found.replaceChildren(...hits.slice(0, 12).map((page) => item(page, words[0])));
});

function rank({ title, all }, words) {
  return words.reduce((sum, word) => sum + (title.toLowerCase().includes(word) ? 100 : 0) + all.split(word).length, 0);
}

function item({ address, title, text }, word) {
  const line = document.createElement("li");
  const link = document.createElement("a");
  link.href = document.body.dataset.root + address;
  link.textContent = title;
  const place = Math.max(0, text.toLowerCase().indexOf(word) - 30);
  const around = document.createElement("small");
  around.textContent = text.slice(place, place + 90);
  line.append(link, around);
  return line;
}
