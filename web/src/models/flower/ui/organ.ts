/**
 * Finds the organ of a volume and names it by the text's materials and modules, since volume labels may be arbitrary.
 */

import type { FlowerPlant, Volumes } from "../flower_plant";
import { text as message } from "../messages.generated";
import { uncommented } from "../texts";

export interface VolumeOrgan {
	/** Volumes of one call of a module, or of the text outside modules. */
	readonly volumes: ReadonlySet<number>;
	/** Number of volumes from the organ's foot to the chosen volume, both counted. */
	readonly segment: number;
}

/** Returns the first volume of an organ, and the number of volumes from there to the chosen one. */
export function footOf(volumes: Volumes, chosen: number): { foot: number; segment: number } {
	const { order, parent } = volumes;
	let [foot, segment] = [chosen, 1];
	for (; parent[foot] < order.length && sameCall(volumes, parent[foot], chosen) && segment < order.length; segment++)
		foot = parent[foot];
	return { foot, segment };
}

/** Returns whether two volumes come from the same call of the same module. */
const sameCall = ({ label, module, call }: Volumes, one: number, other: number): boolean =>
	module[label[one]] === module[label[other]] && call[one] === call[other];

/**
 * Returns the organ of a volume.
 * @param chosen one of `all`
 */
export function organOf(all: Volumes, chosen: number): VolumeOrgan {
	const { order, parent } = all;
	const isOfOrgan = (at: number) => sameCall(all, at, chosen);
	const { foot: root, segment } = footOf(all, chosen);
	const [UNKNOWN, WITHIN, OUT] = [0, 1, 2];
	const states = new Uint8Array(order.length);
	states[root] = WITHIN;
	const volumes = new Set<number>();
	for (let each = 0; each < order.length; each++) {
		const path: number[] = [];
		let at = each;
		// Volumes on the path count as outside until they prove to lead to the root, so that cycles end the walk.
		for (; at < order.length && states[at] === UNKNOWN && isOfOrgan(at); at = parent[at]) {
			states[at] = OUT;
			path.push(at);
		}
		const isInside = at < order.length && states[at] === WITHIN;
		for (const one of path) states[one] = isInside ? WITHIN : OUT;
		if (states[each] === WITHIN) volumes.add(each);
	}
	return { volumes, segment };
}

/**
 * Returns a volume's title from its material's name, prefixed by the kind if the name lacks it: "Tepal, upper
 * epidermis". Without a material it is the volume's label.
 */
export function titleOfVolume(
	{ volumes, numbers, names, meshes }: Pick<FlowerPlant, "volumes" | "numbers" | "names" | "meshes">,
	chosen: number,
): string {
	const at = numbers.indexOf(Math.round(volumes.values[9 * chosen + 8]));
	const [name = "", kind = ""] = at < 0 ? [] : [names[at], meshes[at]?.material];
	const isComplete = name === "" || name.includes(",") || name.includes(kind);
	const words = isComplete ? name || kind : message("kind_and_name", { kind, name });
	return words === "" ? volumes.labels[volumes.label[chosen]] : words.charAt(0).toUpperCase() + words.slice(1);
}

/** Describes a volume's place: "RU1, volume 132: segment 4 of PETAL, which has 108 volumes." */
export function placeOfVolume(
	{ labels, label, module }: Volumes,
	chosen: number,
	{ volumes, segment }: VolumeOrgan,
	text: string,
): string {
	const modules = [...uncommented(text).matchAll(/^[ \t]*#[ \t]*module[ \t]+(\p{L}[\p{L}\p{N}_]*)/gmu)];
	const moduleName = modules[module[label[chosen]] - 1]?.[1];
	const volumeArguments = { name: labels[label[chosen]], number: chosen + 1 };
	const count = volumes.size;
	if (count === 1)
		return moduleName
			? message("volume_module", { ...volumeArguments, module: moduleName })
			: message("volume_place", volumeArguments);
	return moduleName
		? message("volume_in_module", { ...volumeArguments, segment, module: moduleName, count })
		: message("volume_among", { ...volumeArguments, segment, count });
}
