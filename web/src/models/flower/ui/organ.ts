/** The organ that a volume is of, and what it is in words: out of the text alone, for what grammars call their volumes says nothing. */
import type { FlowerPlant, Volumes } from "../flower_plant";
import { uncommented } from "../texts";

export interface Organ {
	/** Of one call of a module, or of the text itself. */
	readonly volumes: ReadonlySet<number>;
	/** How many volumes stand from its foot to the chosen one, both of them counted. */
	readonly segment: number;
}

/** What an organ begins with, and how many volumes stand from there to the chosen one. */
export function footOf(volumes: Volumes, chosen: number): { foot: number; segment: number } {
	const { order, parent } = volumes;
	let [foot, segment] = [chosen, 1];
	for (; parent[foot] < order.length && areOfOne(volumes, parent[foot], chosen) && segment < order.length; segment++)
		foot = parent[foot];
	return { foot, segment };
}

const areOfOne = ({ label, module, call }: Volumes, one: number, other: number): boolean =>
	module[label[one]] === module[label[other]] && call[one] === call[other];

/** @param chosen a volume of those */
export function organOf(all: Volumes, chosen: number): Organ {
	const { order, parent } = all;
	const isOf = (at: number) => areOfOne(all, at, chosen);
	const { foot: root, segment } = footOf(all, chosen);
	const [UNKNOWN, WITHIN, OUT] = [0, 1, 2];
	const known = new Uint8Array(order.length);
	known[root] = WITHIN;
	const volumes = new Set<number>();
	for (let each = 0; each < order.length; each++) {
		const way: number[] = [];
		let at = each;
		// What is on the way is out until it turns out to lead to the root: no way goes round for ever.
		for (; at < order.length && known[at] === UNKNOWN && isOf(at); at = parent[at]) {
			known[at] = OUT;
			way.push(at);
		}
		const within = at < order.length && known[at] === WITHIN;
		for (const one of way) known[one] = within ? WITHIN : OUT;
		if (known[each] === WITHIN) volumes.add(each);
	}
	return { volumes, segment };
}

/** "Tepal, upper epidermis", as its material says: its name, behind its kind where it does not say of what; the symbol of no material. */
export function titleOfVolume(
	{ volumes, numbers, names, meshes }: Pick<FlowerPlant, "volumes" | "numbers" | "names" | "meshes">,
	chosen: number,
): string {
	const at = numbers.indexOf(Math.round(volumes.values[9 * chosen + 8]));
	const [name = "", kind = ""] = at < 0 ? [] : [names[at], meshes[at]?.material];
	const whole = name === "" || name.includes(",") || name.includes(kind);
	const words = whole ? name || kind : `${kind}, ${name}`;
	return words === "" ? volumes.labels[volumes.label[chosen]] : words.charAt(0).toUpperCase() + words.slice(1);
}

/** "RU1, volume 132: segment 4 of PETAL, which has 108 volumes." */
export function placeOfVolume(
	{ labels, label, module }: Volumes,
	chosen: number,
	{ volumes, segment }: Organ,
	text: string,
): string {
	const modules = [...uncommented(text).matchAll(/^[ \t]*#[ \t]*module[ \t]+(\p{L}[\p{L}\p{N}_]*)/gmu)];
	const own = modules[module[label[chosen]] - 1]?.[1];
	const named = `${labels[label[chosen]]}, volume ${chosen + 1}`;
	if (volumes.size === 1) return own ? `${named}: all of ${own}.` : `${named}.`;
	const many = `${volumes.size.toLocaleString("en")} volumes`;
	return `${named}: segment ${segment} ${own ? `of ${own}, which has` : "among"} ${many}.`;
}
