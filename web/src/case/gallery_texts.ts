/** The texts of the gallery, in one part of the page that is loaded after it. */
const FILES = import.meta.glob<string>('../../../cases/*.toml', {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** Texts by the names of cases. */
export const TEXTS = new Map(
  Object.entries(FILES).map(([path, text]) => [
    path.slice(path.lastIndexOf('/') + 1).replace('.toml', ''),
    text,
  ]),
);
