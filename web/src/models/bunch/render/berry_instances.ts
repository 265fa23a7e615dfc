import { type InstancedBufferGeometry, InstancedInterleavedBuffer, InterleavedBufferAttribute } from "three";
import type { Colour } from "../../../plant/colour";
import type { Berries } from "../bunch_plant";
import type { BerryTint } from "../parts/berry_tint";
import { LEAST_LIGHT } from "../parts/skin_rules";
import { halvesOf, traitOf } from "../traits";

/** Attributes of each berry for the shader, four numbers each. */
const ATTRIBUTES = ["centre", "nature", "posed", "ripened", "unripened", "formed"] as const;
const STRIDE = 4 * ATTRIBUTES.length;

/**
 * Attributes of each berry, in the order in which they are drawn:
 *
 *     centre     x, y, z, reach of its vertices      nature     index, mean share of the sky, exposure, 0
 *     posed      direction, phase                    ripened    log of ripe colour, bloom
 *     unripened  log of unripe colour, turned        formed     half width, half length, shrivel, seeds
 */
export class BerryInstances {
	/** Records by berry index. */
	#records = new Float32Array(0);
	#buffer: InstancedInterleavedBuffer | undefined;

	/**
	 * Sets the attributes of all berries, which `order` then writes in the order of drawing.
	 * @param tint returns the colours of a berry by its index
	 * @param reaches greatest distance of each berry's vertices from its centre, metres
	 * @param skies share of the sky that each berry sees, 0 … 1 (skiesOf)
	 */
	show(berries: Berries, tint: (berry: number) => BerryTint, reaches: Float32Array, skies: Float32Array): void {
		const records = new Float32Array(STRIDE * berries.count);
		for (let i = 0; i < berries.count; i++) {
			const { phase, ripe, unripe, bloom } = tint(i);
			const centre = [...berries.spheres.subarray(4 * i, 4 * i + 3), reaches[i]];
			const pose = [...berries.directions.subarray(3 * i, 3 * i + 3), phase];
			const form = [...halvesOf(berries, i), traitOf(berries, i, "shrivel"), traitOf(berries, i, "seeds")];
			records.set(centre, STRIDE * i);
			records.set([i, skies[i], traitOf(berries, i, "exposure"), 0], STRIDE * i + 4);
			records.set(pose, STRIDE * i + 8);
			records.set([...logarithmOf(ripe), bloom], STRIDE * i + 12);
			records.set([...logarithmOf(unripe), traitOf(berries, i, "turned")], STRIDE * i + 16);
			records.set(form, STRIDE * i + 20);
		}
		this.#records = records;
	}

	/** Writes the berries with these indices, in this order, into the geometry that draws them. */
	order(geometry: InstancedBufferGeometry, indices: readonly number[]): void {
		const buffer = this.#roomFor(geometry, indices.length);
		const array = buffer.array as Float32Array;
		indices.forEach((index, at) => {
			array.set(this.#records.subarray(STRIDE * index, STRIDE * (index + 1)), STRIDE * at);
		});
		buffer.clearUpdateRanges();
		buffer.addUpdateRange(0, STRIDE * indices.length);
		buffer.needsUpdate = true;
		geometry.instanceCount = indices.length;
	}

	/**
	 * Returns a buffer for at least `count` berries; it grows by half, because replacing it means a new geometry on the
	 * graphics card.
	 */
	#roomFor(geometry: InstancedBufferGeometry, count: number): InstancedInterleavedBuffer {
		if (this.#buffer && this.#buffer.count >= count) return this.#buffer;
		geometry.dispose();
		const buffer = new InstancedInterleavedBuffer(new Float32Array(STRIDE * Math.ceil(1.5 * count + 1)), STRIDE);
		for (const [k, name] of ATTRIBUTES.entries()) {
			geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, 4, 4 * k));
		}
		this.#buffer = buffer;
		return buffer;
	}
}

/** Returns the logarithms of a colour's channels: colours of pigments mix as their logarithms. */
function logarithmOf(colour: Colour): Colour {
	return colour.map((value) => Math.log(value + LEAST_LIGHT)) as Colour;
}
