// Writes a report page from the pieces of a recording: `node test/page.mjs sample.jsonl > report.html`.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const dist = (name) => readFileSync(fileURLToPath(new URL(`../dist/${name}`, import.meta.url)), "utf8");

const page = (kind, data) => `<!DOCTYPE html>
<html lang="en" data-page="${kind}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Sample</title>
<style>${dist("wisch.css")}</style>
</head>
<body>
<main id="app"></main>
${data}
<script>${dist("wisch.js")}</script>
</body>
</html>
`;

/** Equals `report_page` in src/lib.rs. */
export const reportPage = (recording) => page("report", `<script type="application/x-ndjson" id="recording">${recording.replaceAll("<", "\\u003c")}</script>`);

/** Equals `studio_page` in src/lib.rs. */
export const studioPage = () => page("studio", "");

/** Equals `answers_page` in src/lib.rs. `recordings`: JSON lines, by episode. */
export const answersPage = (query, answers, recordings) => page("answers", [
  `<pre id="query" hidden>${query.replaceAll("<", "&lt;")}</pre>`,
  `<script type="application/json" id="answers">${JSON.stringify(answers).replaceAll("<", "\\u003c")}</script>`,
  ...Object.entries(recordings).map(([id, lines]) => `<script type="application/gzip" data-episode="${id}">${gzipSync(lines).toString("base64")}</script>`),
].join("\n"));

if (process.argv[1] === fileURLToPath(import.meta.url)) process.stdout.write(reportPage(readFileSync(process.argv[2], "utf8")));
