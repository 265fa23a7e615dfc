/** What the command says about itself. */
import { DEFAULT_PRESET, PRESETS } from "../models/bunch/presets/index";
import { BUNCH } from "../models/bunch/species";

/** A mistake in how the command was called: one line, and exit status 2. */
export class UsageError extends Error {
	override name = "UsageError";
}

/** The text of --help. */
export function usage(): string {
	const keys = [...BUNCH.table.links].map(([key, [entry, second]]) => {
		if (second) return `${key}=W,R`;
		return entry.kind === "choice" ? `${key}=${entry.options.join("|")}` : key;
	});
	return `Grows a grape bunch.

  npm run -s grow -- [PRESET | LINK] [--seed N] [--set KEY=VALUE …] [--grammar FILE] [--out FILE]

  PRESET           ${wrapped(PRESETS.map(({ name }) => name))}
                   (default: ${DEFAULT_PRESET})
  LINK             what Copy link copies, or its part from the ? on
  --seed N         0 … 4294967295; another seed is another bunch of the same shape
  --set KEY=VALUE  as often as needed; KEY is one of
                   ${wrapped([...keys, ...BUNCH.details.flatMap(({ settings = [] }) => settings)])}
  --grammar FILE   grammar text in place of the procedure's own
  --out FILE       .glb, .obj (with its .mtl beside it), .json or .csv (berries); without it, JSON goes to
                   standard output
  --help           this

Exit status: 0 grown, 1 the core broke or is missing, 2 something in the call cannot be used.
What the keys mean: docs/models/*/parameters.md, docs/links.md. Fields of the JSON: docs/command-line.md.
`;
}

const WIDTH = 80;
const INDENT = 19;

function wrapped(words: readonly string[]): string {
	const lines = [""];
	for (const word of words) {
		const line = lines[lines.length - 1];
		if (line.length + 1 + word.length > WIDTH) lines.push(word);
		else lines[lines.length - 1] = line ? `${line} ${word}` : word;
	}
	return lines.join(`\n${" ".repeat(INDENT)}`);
}
