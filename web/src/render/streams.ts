import {
	BufferAttribute,
	type BufferGeometry,
	DynamicDrawUsage,
	InstancedBufferAttribute,
	type InstancedBufferGeometry,
	type TypedArray,
} from "three";

/** Content of an attribute: name, numbers, and numbers per item; bytes are shares of 255. */
export type Stream = readonly [name: string, array: TypedArray, size: number];

/**
 * Writes content into a geometry's buffers if they are large enough, else into new buffers with half as much room
 * again, so that dragging rarely allocates. Draws all of `index`.
 */
export function fillStreams(geometry: BufferGeometry, streams: readonly Stream[], index: TypedArray): void {
	const roomy = streams.every(([name, array]) => fits(attributeOf(geometry, name), array));
	if (!roomy || !fits(geometry.index ?? undefined, index)) {
		// three.js frees a disposed geometry's buffers and uploads it again.
		geometry.dispose();
		for (const [name, array, size] of streams) geometry.setAttribute(name, roomyAttribute(array, size));
		geometry.setIndex(roomyAttribute(index, 1));
	}
	for (const [name, array] of streams) fill(attributeOf(geometry, name), array);
	fill(geometry.index ?? undefined, index);
	geometry.setDrawRange(0, index.length);
}

/** Returns a geometry's attribute; undefined if it has none of that name. */
function attributeOf(geometry: BufferGeometry, name: string): BufferAttribute | undefined {
	const attribute = geometry.getAttribute(name);
	return attribute instanceof BufferAttribute ? attribute : undefined;
}

/** Returns whether an existing buffer has room for an array. */
function fits(old: BufferAttribute | undefined, array: TypedArray): boolean {
	return (old?.array.length ?? -1) >= array.length;
}

/**
 * Creates an empty attribute of the same number type with room for half as many numbers again. Bytes are normalised.
 * @param size numbers per item
 */
function roomyAttribute(like: TypedArray, size: number): BufferAttribute {
	const length = Math.ceil((1.5 * like.length) / size) * size;
	if (like instanceof Uint8Array)
		return new BufferAttribute(new Uint8Array(length), size, true).setUsage(DynamicDrawUsage);
	const array = like instanceof Uint32Array ? new Uint32Array(length) : new Float32Array(length);
	return new BufferAttribute(array, size).setUsage(DynamicDrawUsage);
}

/** Writes content into an instanced attribute, as `fillStreams` does; `size` is the count of numbers per instance. */
export function fillInstances(
	geometry: InstancedBufferGeometry,
	name: string,
	values: ArrayLike<number>,
	size: number,
): void {
	const room = attributeOf(geometry, name)?.array.length ?? -1;
	if (values.length > room) {
		geometry.dispose();
		const array = new Float32Array(size * Math.ceil(Math.max(values.length, 1.5 * room, 1) / size));
		geometry.setAttribute(name, new InstancedBufferAttribute(array, size).setUsage(DynamicDrawUsage));
	}
	fill(attributeOf(geometry, name), values);
}

/** Writes an attribute's first items and uploads only these to the GPU; does nothing without an attribute. */
function fill(attribute: BufferAttribute | undefined, array: ArrayLike<number>): void {
	if (!attribute) return;
	attribute.array.set(array);
	attribute.clearUpdateRanges();
	attribute.addUpdateRange(0, array.length);
	attribute.needsUpdate = true;
}
