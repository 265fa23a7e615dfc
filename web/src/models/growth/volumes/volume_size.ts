/** Height and width of a tree's growth volumes together, which the panel sets with a slider and a field. */
import { NO_PARAMETER, type Quantity } from "../../../ui/quantity";
import type { GrowthPlant } from "../growth_plant";
import { text } from "../messages.generated";
import type { GrowthSpecimen } from "../specimen";
import { type GrowthVolume, HIGHEST, LOWEST, meanWidth, WIDEST } from "./volume";
import { put, volumesOf } from "./volume_tool";

type GrowthQuantity = Quantity<GrowthSpecimen, GrowthPlant>;

const METRES = { ...NO_PARAMETER, kind: "number", unit: "m", step: 0.1 } as const;

/** Greatest height or width of volumes; undefined without volumes. */
const greatest = (volumes: readonly GrowthVolume[], of: (volume: GrowthVolume) => number): number | undefined =>
	volumes.length === 0 ? undefined : Math.max(...volumes.map(of));

const heightOf = ({ height }: GrowthVolume): number => height;
const widthOf = ({ base, middle, top }: GrowthVolume): number => Math.max(base, middle, top);

/** Multiplies the heights of volumes so that the highest has the given height, metres. */
export function withHeight(volumes: readonly GrowthVolume[], height: number): readonly GrowthVolume[] {
	const factor = height / (greatest(volumes, heightOf) || 1);
	return volumes.map((volume) => ({ ...volume, height: Math.max(LOWEST, volume.height * factor) }));
}

/** Multiplies the widths of volumes so that the widest has the given width, metres; a frustum stays one. */
export function withWidth(volumes: readonly GrowthVolume[], width: number): readonly GrowthVolume[] {
	const factor = width / (greatest(volumes, widthOf) || 1);
	return volumes.map((volume) => {
		const [base, top] = [volume.base * factor, volume.top * factor];
		const isFrustum = volume.middle === meanWidth(volume.base, volume.top);
		return { ...volume, base, top, middle: isFrustum ? meanWidth(base, top) : volume.middle * factor };
	});
}

export const VOLUME_SIZES: readonly GrowthQuantity[] = [
	{
		...METRES,
		key: "height",
		min: LOWEST,
		max: HIGHEST,
		get label() {
			return text("size_height");
		},
		get help() {
			return text("size_height_help");
		},
		read: (specimen, grown) => greatest(volumesOf(specimen, grown), heightOf),
		change: (specimen, height, grown) => put(specimen, withHeight(volumesOf(specimen, grown), height)),
	},
	{
		...METRES,
		key: "width",
		min: LOWEST,
		max: WIDEST,
		get label() {
			return text("size_width");
		},
		get help() {
			return text("size_width_help");
		},
		read: (specimen, grown) => greatest(volumesOf(specimen, grown), widthOf),
		change: (specimen, width, grown) => put(specimen, withWidth(volumesOf(specimen, grown), width)),
	},
];
