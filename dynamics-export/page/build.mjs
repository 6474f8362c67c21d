// Makes page.js and page.css in `dist`, or in the folder that is named, from the sources and the packages
// of the lock file: called in the folder that it stands in. The same sources give the same bytes.

import { readFileSync } from "node:fs";
import { build } from "esbuild";

const out = process.argv[2] ?? "dist";
const licence = (name) => {
  const { version } = JSON.parse(readFileSync(`node_modules/${name}/package.json`, "utf8"));
  const text = readFileSync(`node_modules/${name}/LICENSE`, "utf8").trim();
  return `${name} ${version}\n\n${text}`;
};
const notices = ["three", "uplot"].map(licence).join("\n\n");

// The shaders of three.js are indented, in strings that nothing else makes shorter.
const shaders = {
  name: "shaders",
  setup: ({ onLoad }) =>
    onLoad({ filter: /three\.(module|core)\.js$/ }, ({ path }) => ({
      contents: readFileSync(path, "utf8").replace(/\\n(\\t)+/g, "\\n"),
    })),
};

await build({
  plugins: [shaders],
  entryPoints: { page: "src/main.js" },
  outdir: out,
  bundle: true,
  minify: true,
  format: "esm",
  // What browsers of 2021 read.
  target: ["es2021"],
  charset: "ascii",
  legalComments: "none",
  banner: { js: `/*! This script holds the following works.\n\n${notices}\n*/` },
  logLevel: "warning",
});
