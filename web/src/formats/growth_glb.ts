/**
 * The *growth* form: a plant's life as an animation that every reader of glTF plays. Each age is a light plant of its
 * own in the same place; the scales of nodes, which step from 0 to 1 and back, show one at a time. So colours, flowers
 * and all other parts are those of the age. Morphing one mesh could not do that: stems and berries appear and vanish,
 * and few readers morph colours.
 */
import type { Material } from "../plant/material";
import type { Part, Shape } from "../plant/part";
import type { About } from "./about";
import type { Moment } from "./animation";
import { exportGlb } from "./glb";
import { lightParts } from "./light";
import { palettedByMaterial } from "./palette";

/** A plant at other ages. */
export interface Aged {
	/** From the youngest to the oldest, in the unit of the plant's age. */
	readonly ages: readonly number[];
	at(age: number): Promise<Iterable<Part>>;
}

/** The most triangles of each age. */
const AGE_TRIANGLES = 5000;
/** Seconds of the whole animation, and of the rest at its end. */
const SECONDS = 10;
const REST = 2;
const PIXELS = 128;

/**
 * Writes the file: plain glTF; readers without animation show the oldest age. Ages before the first visible part are
 * left out.
 */
export async function growthGlb({ ages, at }: Aged, about: About): Promise<Uint8Array<ArrayBuffer>> {
	const parts: Part[] = [];
	const moments = new Map<string, Moment>();
	const grown: Part[][] = [];
	for (const age of ages) grown.push(await lightParts(await at(age), { triangles: AGE_TRIANGLES, pixels: PIXELS }));
	const alike = withOneMaterialAKind(grown, ages);
	for (const [i, age] of ages.entries()) {
		const children = alike[i];
		if (children.length === 0) continue;
		const name = `Age ${age}`;
		const time = (k: number) => (SECONDS * k) / (ages.length - 1);
		parts.push({ name, children });
		moments.set(name, { from: time(i), ...(i < ages.length - 1 ? { until: time(i + 1) } : { rest: SECONDS + REST }) });
	}
	return exportGlb(parts, about, { moments });
}

/**
 * Returns the parts of all ages with unique names and one material per name: that of the oldest age, whose picture has
 * the colours of all ages. A material with a picture of its own has another one at every age: it stays, and its name
 * includes the age.
 */
function withOneMaterialAKind(grown: readonly Part[][], ages: readonly number[]): Part[][] {
	const oldest = new Map<string, Material>();
	for (const { shape } of grown.flat())
		if (shape && !shape.material.textures?.colour) oldest.set(shape.material.name, shape.material);
	const shapes = grown.map((parts, i) =>
		parts.map(({ shape }) => {
			if (!shape) return undefined;
			const { material } = shape;
			if (material.textures?.colour)
				return { ...shape, material: { ...material, name: atAge(material.name, ages[i]) } };
			return { ...coloured(shape), material: oldest.get(material.name) ?? material };
		}),
	);
	const painted = palettedByMaterial(shapes.flat().filter((shape) => shape !== undefined));
	return grown.map((parts, i) => {
		const counts = new Map<string, number>();
		return parts.map((part, k) => {
			const count = (counts.get(part.name) ?? 0) + 1;
			counts.set(part.name, count);
			const shape = shapes[i][k];
			const numbered = count > 1 ? `${part.name} ${count}` : part.name;
			const name = atAge(numbered, ages[i]);
			return { ...part, name, ...(shape && { shape: painted.get(shape) ?? shape }) };
		});
	});
}

/** Returns the name of a part or a material at one age. */
const atAge = (name: string, age: number) => `${name}, age ${age}`;

/** Returns a shape with vertex colours: its material's colour where it had none. */
function coloured(shape: Shape): Shape {
	const { mesh, material } = shape;
	if (mesh.colours) return shape;
	return { ...shape, mesh: { ...mesh, colours: mesh.positions.map((_, i) => material.colour[i % 3]) } };
}
