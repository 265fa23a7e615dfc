/** The page docs/messages.md: codes of errors and notes, with their English texts, from the catalogues of messages. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { repository } from "../repository.mjs";
import { coreCatalogues, coreRoomCode, pageCatalogues, pageRoomCode } from "./messages.mjs";

/** Keys that the code of a room uses with their codes: `text.message("too_large", …)`. */
function codedKeys(room) {
	const folder = join(repository, "web/src", room);
	const files = readdirSync(folder, { recursive: true, encoding: "utf8" }).filter(
		(name) => name.endsWith(".ts") && !name.includes(".generated."),
	);
	const keys = files.flatMap((name) =>
		[...readFileSync(join(folder, name), "utf8").matchAll(/\btext\.message\(\s*"([a-z0-9_]+)"/g)].map(([, key]) => key),
	);
	return new Set(keys);
}

const cell = (text) => text.replaceAll("|", "\\|").replaceAll("{", "\\{").replaceAll("}", "\\}");

function section(title, rows) {
	const lines = rows.map(([code, message]) => `| \`${code}\` | ${cell(message)} |`);
	return `### ${title}\n\n| code | message |\n|---|---|\n${lines.join("\n")}\n`;
}

function sectionOf(code, messages, keys) {
	const rows = Object.entries(messages)
		.filter(([key]) => keys === undefined || keys.has(key))
		.map(([key, message]) => [`${code}.${key}`, message]);
	return rows.length > 0 ? [section(code, rows)] : [];
}

/** Returns the generated page. */
export function outputs() {
	const core = coreCatalogues().flatMap(({ room, messages }) => sectionOf(coreRoomCode(room), messages));
	const page = pageCatalogues().flatMap(({ room, messages }) =>
		sectionOf(pageRoomCode(room), messages, codedKeys(room)),
	);
	return [
		{
			path: "docs/messages.md",
			text: `<!-- Generated from the files messages.json by \`npm run docs\`; do not edit. -->

# Messages and their codes

Errors and notes have a code and named arguments besides their sentence, so that programs can tell them apart and show them in
another language. A \`CoreError\` of the library, for example, has \`code\`, \`args\`, \`line\` and \`column\`:

\`\`\`js
try {
	await grow("grammar", { grammar: "omega: A(" });
} catch (error) {
	console.log(error.code, error.args, error.message);
}
\`\`\`

Codes never change their meaning. A message that is no longer needed goes; a new one gets a new code. \`{name}\` is an argument;
\`{count, plural, …}\` chooses words by a number (ICU MessageFormat).

## Of the core

${core.join("\n")}
## Of the page, the element, the package, the service and the command line

${page.join("\n")}`,
		},
	];
}
