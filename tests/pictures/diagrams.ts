/** Floral diagrams and side elevations of the designed flowers, as files of docs/models/flower/diagrams. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { coreFolder } from "../../wasm-core/tools/repository.mjs";
import type { Description } from "../../web/src/models/flower/design/description";
import { describedIn, designOf } from "../../web/src/models/flower/design/design";
import { ORGANS } from "../../web/src/models/flower/design/organs";
import { elevation } from "../../web/src/models/flower/ui/design/elevation";
import { floralDiagram } from "../../web/src/models/flower/ui/design/floral_diagram";
import { pictureOf } from "../../web/src/models/flower/ui/design/scene";
import type { DocsFile } from "./docs_file";

const grammars = join(coreFolder, "grammars/flower");

/** The description of each organ of a designed flower. */
export const descriptionsOf = (text: string): readonly Description[] => {
	const design = designOf(text);
	if (!design) throw new Error("The text holds no design.");
	return ORGANS.map((organ) => describedIn(design, organ));
};

/** The designed flowers among the presets. */
export const designedFlowers = () =>
	readdirSync(grammars)
		.filter((file) => file.startsWith("designed-"))
		.map((file) => ({
			name: file.replace(/^designed-|\.gl3$/g, ""),
			descriptions: descriptionsOf(readFileSync(join(grammars, file), "utf8")),
		}));

export function diagrams(): DocsFile[] {
	const folder = "docs/models/flower/diagrams";
	return designedFlowers().flatMap(({ name, descriptions }) => [
		{
			path: `${folder}/${name}-diagram.svg`,
			text: pictureOf(floralDiagram(descriptions), `Floral diagram of the ${name}`),
		},
		{
			path: `${folder}/${name}-elevation.svg`,
			text: pictureOf(elevation(descriptions), `Side elevation of the ${name}`),
		},
	]);
}
