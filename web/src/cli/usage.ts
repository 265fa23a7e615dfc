/** Help and errors of the command. */

import { formatKeysOf } from "../batch/series";

import { FORMS, LOW_TRIANGLES, POINTS, THICKNESS } from "../formats/plant_files";

import { DEFAULT_MODEL } from "../models/index";
import type { Model } from "../models/model";
import { fromPreset } from "../specimen/from_preset";
import { endingsOf } from "./outputs";

/** An error in the call of the command: one line, and exit status 2. */
export class UsageError extends Error {
	override name = "UsageError";

	/** @param below lines below the message: a text's line with a mark at the position */
	constructor(
		message: string,
		readonly below = "",
	) {
		super(message);
	}
}

/** Exit status where everything is grown and a target is missed. */
export const MISSED = 3;

/** Exit status where the time limit, `--seconds`, was reached. */
export const TIME_OVER = 5;

/** Exit status where a limit of the core cut the plant short. */
export const CUT_SHORT = 6;

/** The text of --help for one model, with the names of the others. */
export function usage(model: Model, models: readonly string[]): string {
	const { name, title, noun, table, presets, details, formats, targets } = model;
	const keys = [...table.links].map(([key, entries]) => {
		const [entry, ...others] = entries;
		if (others.length > 0) return `${key}=${entries.map((_, index) => String.fromCharCode(65 + index)).join()}`;
		return entry.kind === "choice" ? `${key}=${entry.options.join("|")}` : key;
	});
	const reachable = targets?.measures(fromPreset(model)) ?? [];
	const prefix = name === DEFAULT_MODEL ? "" : `${name}/`;
	const others = models.filter((each) => each !== name).map((each) => `${each} --help`);
	return `Grows a plant; here: ${title.toLowerCase()}.

  npm run -s grow -- [MODEL/PRESET | PRESET | LINK] [--seed N] [--set KEY=VALUE …] [--target MEASURE=VALUE …]
                     [--grammar FILE] [--string] [--chronicle STEP] [--boundary FILE] [--out FILE]
                     [--form FORM] [--triangles N] [--translucent] [--textures] [--thickness MM] [--points N]
                     [--seconds N]
  npm run -s grow -- … --seeds 1-100 [--vary KEY=FROM..TO,…] [--shard PART/PARTS] [--as KIND,…] --out DIR
  npm run -s grow -- --list

  MODEL/PRESET     a preset of any model (--list): ${name}/${presets.standard}; MODEL alone is its first choice
  PRESET           ${wrapped(presets.list.map((preset) => prefix + preset.name))}
                   (default: ${prefix}${presets.standard}${prefix === "" ? `; ${name}/ before them may be left out` : ""})
  LINK             what Copy link copies, or its part from the ? on
  --seed N         0 … 4294967295; another seed is another ${noun} of the same shape
  --set KEY=VALUE  as often as needed; KEY is one of
                   ${wrapped([...keys, ...details.flatMap(({ settings = [] }) => settings)])}
${
	reachable.length > 0
		? `  --target M=VALUE searches for the parameters with which the measure M comes nearest to the value;
                   FROM..TO draws the value from a range; may be repeated; M is one of
                   ${wrapped(reachable)}
`
		: ""
}  --grammar FILE   grammar text in place of the preset's; without a preset, the text decides which
                   model grows, and the ending of the file's name where the text fits none
  --string         the JSON has the derived string, of plants that any text grows
  --chronicle STEP the JSON tells of that step of the derivation: which production fired
                   where and with what values; STEP,FIRST,COUNT of so many modules from one on
  --boundary FILE  a closed mesh, .obj, .glb or .stl, that a tree or a root grows in
  --out FILE       ${endingsOf({ formats })} (an .obj has its
                   .mtl beside it); without it, JSON goes to standard output
  --form FORM      of a .glb: ${FORMS.join(", ")} (default: ${FORMS[0]})
  --triangles N    of the form low, at the most (default: ${LOW_TRIANGLES})
  --thickness MM   that nothing is thinner than in an .stl or .3mf (default: ${THICKNESS})
  --points N       of a .ply (default: ${POINTS})
  --translucent    light comes through pale skins in a .glb, which costs readers a pass
  --textures       a detailed .glb has pictures of colour, shade, roughness and relief, not
                   colours of vertices
  --seconds N      ends within about N seconds with what has grown so far; a series ends with
                   the plants that are written, and the same call continues it
  --seeds 1-100    a series: a file for each plant and a table, plants.csv, into the folder DIR;
                   what is there and whole is not grown again (docs/batch.md). These are the
                   plants' numbers; each plant's seed is drawn from its number, the preset and
                   the settings
  --literal-seeds  the numbers of --seeds are the seeds themselves
  --vary KEY=…     drawn for each plant: age=60..110, or one of a few: fruit=lychee|duku
  --shard 3/16     that part of the series; auto in a Slurm array, auto/16 in a Kubernetes Job
  --as KIND,…      ${wrapped(formatKeysOf({ formats }))} (default: glb)
  --list           all models with their presets, as JSON
  --help           ${wrapped(others.length > 0 ? ["this;", "of", "other", "models:", ...others] : ["this"])}

Exit status: 0 grown; 1 the core failed or is missing, a file could not be written, or plants of a
series did not grow; 2 a mistake in the call; 3 grown, but a --target is missed; 4 the plant is empty
and the file cannot be; 5 the time limit (--seconds) was reached; 6 a limit of the core cut the plant
short.
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
