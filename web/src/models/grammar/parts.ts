/** What a text has grown in parts: lines by their colours, what is borne by its kind and colour. */
import { linear } from "../../plant/colour";
import { type Material, standardMaterial } from "../../plant/material";
import { cut, type Part, TRANSFORM } from "../../plant/part";
import type { PlantMesh } from "../../plant/plant";
import type { GrammarPlant } from "./grammar_plant";
import type { ColourKey } from "./parameters.generated";
import type { GrammarSpecimen } from "./specimen";

/** More of a kind than these nobody picks one by one: none has a name of its own, and files hold them in a few meshes. */
const MOST_NAMED = 300;

export function* grammarParts(plant: GrammarPlant, { look }: GrammarSpecimen): Generator<Part> {
	const names = new Set<string>();
	const called = (name: string) => {
		for (let number = 1; ; number++) {
			const tried = number === 1 ? name : `${name} ${number}`;
			if (names.has(tried)) continue;
			names.add(tried);
			return tried;
		}
	};
	const dressed = new Map<string, Material>();
	const materialOf = (kind: string, colour: number) => {
		const known = dressed.get(`${kind} ${colour}`) ?? painted(kind, colour, look);
		dressed.set(`${kind} ${colour}`, known);
		return known;
	};
	for (const [index, mesh] of plant.meshes.entries()) {
		const colours = plant.runColours[mesh.name];
		if (!colours) {
			yield* borneParts(plant, index, mesh, materialOf, called);
			continue;
		}
		for (const [run, range] of mesh.runs.entries()) {
			if (range.indexCount === 0) continue;
			const material = materialOf(mesh.material, colours[run]);
			yield { name: called(range.name), shape: { mesh: cut(mesh, range), material } };
		}
	}
}

/** A material of a kind in a colour of the palette. */
function painted(kind: string, colour: number, look: GrammarSpecimen["look"]): Material {
	const standard = standardMaterial(kind);
	const key = `colour${colour}` as ColourKey;
	return { ...standard, name: `${standard.name} ${colour}`, colour: linear(look[key]) };
}

/** The organs that are drawn with a mesh, as instances: a part for each colour. */
function* borneParts(
	{ organs, borne }: GrammarPlant,
	index: number,
	mesh: PlantMesh,
	materialOf: (kind: string, colour: number) => Material,
	called: (name: string) => string,
): Generator<Part> {
	const byColour = new Map<number, number[]>();
	for (let organ = 0; organ < organs.count; organ++) {
		if (organs.mesh[organ] !== index) continue;
		const members = byColour.get(borne.colour[organ]) ?? [];
		byColour.set(borne.colour[organ], members);
		members.push(organ);
	}
	for (const [colour, members] of [...byColour].sort(([a], [b]) => a - b)) {
		const transforms = new Float32Array(TRANSFORM * members.length);
		members.forEach((organ, i) => {
			transforms.set(organs.transforms.subarray(TRANSFORM * organ, TRANSFORM * (organ + 1)), TRANSFORM * i);
		});
		const kind = titled(organs.tags[organs.tag[members[0]]] ?? mesh.name);
		const { sky } = organs;
		const each = (i: number) => ({
			name: `${kind} ${members[i] + 1}`,
			extras: { segment: organs.segment[members[i]], module: borne.module[members[i]] },
		});
		yield {
			name: called(`${kind} ${colour}`),
			shape: {
				mesh,
				material: materialOf(mesh.material, colour),
				instances: {
					transforms,
					...(organs.count > MOST_NAMED ? {} : { each }),
					...(sky ? { sky: Uint8Array.from(members, (organ) => sky[organ]) } : {}),
				},
			},
		};
	}
}

const titled = (name: string) => `${name.charAt(0).toUpperCase()}${name.slice(1)}`;
