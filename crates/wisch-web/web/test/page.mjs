// Writes a report page from the pieces of a recording: `node test/page.mjs sample.jsonl > report.html`.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const dist = (name) => readFileSync(fileURLToPath(new URL(`../dist/${name}`, import.meta.url)), "utf8");

/** Equals `report_page` in src/lib.rs. */
export const reportPage = (recording) => `<!DOCTYPE html>
<html lang="en" data-page="report">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Sample</title>
<style>${dist("wisch.css")}</style>
</head>
<body>
<main id="app"></main>
<script type="application/x-ndjson" id="recording">${recording.replaceAll("<", "\\u003c")}</script>
<script>${dist("wisch.js")}</script>
</body>
</html>
`;

if (process.argv[1] === fileURLToPath(import.meta.url)) process.stdout.write(reportPage(readFileSync(process.argv[2], "utf8")));
