/** The organ that a volume is of, and what it is in words: out of the text alone, for what grammars call their volumes says nothing. */
import type { FlowerPlant, Volumes } from "../flower_plant";
import { uncommented } from "../texts";

export interface Organ {
	/** Of one call of a module, or of the text itself. */
	readonly volumes: ReadonlySet<number>;
	/** How many volumes stand from its foot to the chosen one, both of them counted. */
	readonly segment: number;
}

/** @param chosen a volume of those */
export function organOf({ order, parent, label, module, call }: Volumes, chosen: number): Organ {
	const isOf = (at: number) => module[label[at]] === module[label[chosen]] && call[at] === call[chosen];
	let [root, segment] = [chosen, 1];
	for (; parent[root] < order.length && isOf(parent[root]) && segment < order.length; segment++) root = parent[root];
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
