/**
 * Fewer but larger instances: a crown of a tenth of its leaves that covers the same area, by stochastic simplification
 * (Cook et al. 2007, "Stochastic simplification of aggregate detail").
 */
import { everyPart, type Instances, type Part, TRANSFORM } from "../plant/part";

/** The least triangles per instance: two make a sheet that folds, two more a tip and a base. */
const LEAST_TRIANGLES = 4;
/** The share of all triangles for such instances. */
const SHARE = 0.6;

/**
 * Returns the parts with fewer instances of those that are no parts by themselves, so that they fit a budget of
 * triangles; always the same ones.
 */
export function sparse(parts: readonly Part[], triangles: number): Part[] {
	const count = [...everyPart(parts)].reduce((sum, { shape }) => sum + countOf(shape?.instances), 0);
	const keep = Math.min(1, (SHARE * triangles) / LEAST_TRIANGLES / count);
	return keep < 1 ? parts.map((part) => thinned(part, keep)) : [...parts];
}

/** Returns the number of instances that are no parts by themselves. */
const countOf = (instances?: Instances) => (instances && !instances.each ? instances.transforms.length / TRANSFORM : 0);

/**
 * Returns a part, and its children, with a share of the instances.
 * @param keep the share, 0 … 1
 */
function thinned(part: Part, keep: number): Part {
	const { shape, children } = part;
	const held = children ? { ...part, children: children.map((child) => thinned(child, keep)) } : part;
	if (!shape?.instances || countOf(shape.instances) === 0) return held;
	return { ...held, shape: { ...shape, instances: fewer(shape.instances, keep) } };
}

/**
 * Returns evenly selected instances, enlarged so that they cover the same area. They are in the order of growth, so
 * that neighbours follow each other.
 * @param keep the share of them, 0 … 1
 */
function fewer({ transforms, sky, ...rest }: Instances, keep: number): Instances {
	const count = transforms.length / TRANSFORM;
	const evenly = Array.from({ length: Math.max(1, Math.round(keep * count)) }, (_, i) => Math.floor((i + 0.5) / keep));
	const chosen = evenly.filter((index) => index < count);
	const larger = 1 / Math.sqrt(keep);
	const own = new Float32Array(TRANSFORM * chosen.length);
	for (const [to, index] of chosen.entries()) {
		own.set(transforms.subarray(TRANSFORM * index, TRANSFORM * (index + 1)), TRANSFORM * to);
		own[TRANSFORM * to + 7] *= larger;
	}
	return { ...rest, transforms: own, ...(sky ? { sky: Uint8Array.from(chosen, (index) => sky[index]) } : {}) };
}
