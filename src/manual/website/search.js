// Searches the manual. An entry of INDEX has a file, a topic, a heading, an anchor and the lines below the heading.
const MAX_HITS = 40;
// The maximum length of the text of a hit, in characters.
const MAX_LENGTH = 200;
const form = document.querySelector('form');
const input = form.querySelector('input');
const hits = document.querySelector('.hits');
const main = document.querySelector('main');

// Case does not matter, and Turkish letters match the ASCII letters that they look like. No text changes its length.
const spelled = text => text.replace(/[ıİI]/g, 'i').toLowerCase().normalize('NFD').replace(/\p{M}/gu, '');
const sections = INDEX.map(([file, topic, heading, anchor, text]) => {
  const title = topic === heading ? heading : `${topic}: ${heading}`;
  const lines = text.split('\n');
  return { link: `${file}#${anchor}`, title, spelledTitle: spelled(title), lines, spelledLines: lines.map(spelled) };
});

// Returns where a word of the text starts with these letters, or -1.
function find(text, start) {
  let at = text.indexOf(start);
  while (at > 0 && /[\p{L}\p{N}]/u.test(text[at - 1])) {
    at = text.indexOf(start, at + 1);
  }
  return at;
}

// Returns a section as a hit, with the part of a line around a word.
function hit(section, line, word) {
  const link = document.createElement('a');
  link.href = section.link;
  link.textContent = section.title;
  const text = section.lines[line];
  const from = Math.max(0, text.lastIndexOf(' ', find(section.spelledLines[line], word) - 60));
  const isCut = from + MAX_LENGTH < text.length;
  const to = isCut ? text.lastIndexOf(' ', from + MAX_LENGTH) : text.length;
  const about = document.createElement('p');
  const part = text.slice(from, to > from ? to : from + MAX_LENGTH).trim();
  about.textContent = (from > 0 ? '... ' : '') + part + (isCut ? ' ...' : '');
  const item = document.createElement('li');
  item.append(link, about);
  return item;
}

function search() {
  const words = spelled(input.value).split(/\s+/).filter(Boolean);
  const phrase = words.join(' ');
  const areIn = text => words.every(word => find(text, word) >= 0);
  // Sections with the words in their title come first, then those with the words side by side.
  const [inTitle, together, apart] = [[], [], []];
  for (const section of words.length > 0 ? sections : []) {
    const side = section.spelledLines.findIndex(text => find(text, phrase) >= 0);
    const any = section.spelledLines.findIndex(text => areIn(`${section.spelledTitle} ${text}`));
    const line = side >= 0 ? side : any;
    if (line >= 0) {
      const kind = areIn(section.spelledTitle) ? inTitle : side >= 0 ? together : apart;
      kind.push(hit(section, line, side >= 0 ? phrase : words[0]));
    }
  }
  const found = [...inTitle, ...together, ...apart].slice(0, MAX_HITS);
  hits.replaceChildren(...(found.length > 0 ? found : [hits.dataset.none]));
  main.hidden = words.length > 0;
  hits.hidden = !main.hidden;
}

form.hidden = false;
input.addEventListener('input', search);
form.addEventListener('submit', event => {
  event.preventDefault();
  hits.querySelector('a')?.click();
});
// A link to a heading of the same page loads no page.
hits.addEventListener('click', event => {
  if (event.target.closest('a')) {
    input.value = '';
    search();
  }
});
