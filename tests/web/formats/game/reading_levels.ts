/** Reads levels of a game tree and draws their silhouettes, without any code of the page. */
import { inflateSync } from "node:zlib";
import type { Part } from "../../../../web/src/plant/part";

interface Accessor {
	bufferView: number;
	byteOffset?: number;
	componentType: number;
	count: number;
	type: string;
	normalized?: boolean;
}

export interface Picture {
	width: number;
	height: number;
	channels: number;
	pixels: Uint8Array;
}

export interface Primitive {
	material: string;
	/** Three numbers a vertex, two a vertex, three a triangle. */
	positions: ArrayLike<number>;
	uvs: ArrayLike<number>;
	indices: ArrayLike<number>;
	attributes: Record<string, number[][]>;
	/** The colour picture of a material that is cut out. */
	cut: Picture | undefined;
}

const COMPONENTS: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** The pixels of a PNG of 8 bits whose rows are differences from the row above. */
export function pixelsOf(file: Uint8Array): Picture {
	const view = new DataView(file.buffer, file.byteOffset);
	const [width, height] = [view.getUint32(16), view.getUint32(20)];
	const channels = { 0: 1, 2: 3, 6: 4 }[file[25]] ?? 0;
	const rows = inflateSync(file.subarray(41, 41 + view.getUint32(33)));
	const pixels = new Uint8Array(channels * width * height);
	const row = channels * width;
	for (let i = 0; i < pixels.length; i++)
		pixels[i] = rows[i + 1 + Math.floor(i / row)] + (i >= row ? pixels[i - row] : 0);
	return { width, height, channels, pixels };
}

/** The document and its meshes, by the names of their nodes. */
export function readLevels(glb: Uint8Array) {
	const view = new DataView(glb.buffer, glb.byteOffset, glb.byteLength);
	const length = view.getUint32(12, true);
	const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)));
	const binary = 28 + length;
	const bytesOf = (index: number) => {
		const { byteOffset = 0, byteLength } = json.bufferViews[index];
		return glb.subarray(binary + byteOffset, binary + byteOffset + byteLength);
	};
	const valuesOf = (index: number): number[][] => {
		const accessor: Accessor = json.accessors[index];
		const { byteOffset = 0, byteStride } = json.bufferViews[accessor.bufferView];
		const size = COMPONENTS[accessor.type];
		const width = { 5121: 1, 5123: 2, 5125: 4, 5126: 4 }[accessor.componentType] ?? 0;
		const scale = accessor.normalized ? 2 ** (8 * width) - 1 : 1;
		return Array.from({ length: accessor.count }, (_, i) =>
			Array.from({ length: size }, (__, k) => {
				const at = binary + byteOffset + (accessor.byteOffset ?? 0) + i * (byteStride ?? size * width) + k * width;
				if (accessor.componentType === 5126) return view.getFloat32(at, true);
				return (
					(width === 1 ? view.getUint8(at) : width === 2 ? view.getUint16(at, true) : view.getUint32(at, true)) / scale
				);
			}),
		);
	};
	const primitiveOf = ({
		attributes,
		indices,
		material,
	}: {
		attributes: Record<string, number>;
		indices: number;
		material: number;
	}): Primitive => {
		const { name, alphaMode, pbrMetallicRoughness } = json.materials[material];
		const corners = valuesOf(indices).flat();
		const all = Object.fromEntries(Object.entries(attributes).map(([key, index]) => [key, valuesOf(index)]));
		const source = json.textures?.[pbrMetallicRoughness.baseColorTexture?.index]?.source;
		return {
			material: name,
			positions: Float64Array.from(all.POSITION.flat()),
			uvs: Float64Array.from((all.TEXCOORD_0 ?? []).flat()),
			indices: Uint32Array.from(corners),
			attributes: all,
			cut: alphaMode === "MASK" ? pixelsOf(bytesOf(json.images[source].bufferView)) : undefined,
		};
	};
	const meshes: Record<string, Primitive[]> = {};
	for (const { name, mesh } of json.nodes)
		if (mesh !== undefined) meshes[name] = json.meshes[mesh].primitives.map(primitiveOf);
	return { json, meshes };
}

export interface Frame {
	/** Radians about +Y. */
	azimuth: number;
	/** The middle of the view, and half of its edge, metres. */
	middle: readonly number[];
	half: number;
	pixels: number;
}

/** The share of each pixel that triangles cover, by 4 × 4 points, seen from the side; pixels of cut-out pictures count where opaque. */
export function coverageOf(primitives: readonly Primitive[], { azimuth, middle, half, pixels }: Frame): Float32Array {
	const points = 4 * pixels;
	const hit = new Uint8Array(points * points);
	const [cos, sin] = [Math.cos(azimuth), Math.sin(azimuth)];
	const scale = points / (2 * half);
	for (const { positions, uvs, indices, cut } of primitives) {
		const [us, vs] = [new Float64Array(positions.length / 3), new Float64Array(positions.length / 3)];
		for (let i = 0; i < us.length; i++) {
			us[i] = ((positions[3 * i] - middle[0]) * cos - (positions[3 * i + 2] - middle[2]) * sin + half) * scale - 0.5;
			vs[i] = (half - (positions[3 * i + 1] - middle[1])) * scale - 0.5;
		}
		for (let at = 0; at < indices.length; at += 3) {
			const a = indices[at];
			const b = indices[at + 1];
			const c = indices[at + 2];
			const area = (us[b] - us[a]) * (vs[c] - vs[a]) - (us[c] - us[a]) * (vs[b] - vs[a]);
			if (Math.abs(area) < 1e-9) continue;
			const [top, bottom] = [
				Math.max(0, Math.ceil(Math.min(vs[a], vs[b], vs[c]))),
				Math.min(points - 1, Math.max(vs[a], vs[b], vs[c])),
			];
			const [left, right] = [
				Math.max(0, Math.ceil(Math.min(us[a], us[b], us[c]))),
				Math.min(points - 1, Math.max(us[a], us[b], us[c])),
			];
			for (let y = top; y <= bottom; y++)
				for (let x = left; x <= right; x++) {
					const wb = ((x - us[a]) * (vs[c] - vs[a]) - (us[c] - us[a]) * (y - vs[a])) / area;
					const wc = ((us[b] - us[a]) * (y - vs[a]) - (x - us[a]) * (vs[b] - vs[a])) / area;
					if (wb < 0 || wc < 0 || wb + wc > 1 || hit[points * y + x] > 0) continue;
					if (cut && !isOpaque(cut, mixOf(uvs, [a, b, c], [1 - wb - wc, wb, wc]))) continue;
					hit[points * y + x] = 1;
				}
		}
	}
	const shares = new Float32Array(pixels * pixels);
	for (let i = 0; i < hit.length; i++) {
		const [column, row] = [Math.floor((i % points) / 4), Math.floor(i / points / 4)];
		shares[pixels * row + column] += hit[i] / 16;
	}
	return shares;
}

/** The texture coordinates of a point of a triangle. */
function mixOf(
	uvs: ArrayLike<number>,
	[a, b, c]: readonly number[],
	[wa, wb, wc]: readonly number[],
): readonly number[] {
	return [
		wa * uvs[2 * a] + wb * uvs[2 * b] + wc * uvs[2 * c],
		wa * uvs[2 * a + 1] + wb * uvs[2 * b + 1] + wc * uvs[2 * c + 1],
	];
}

export function isOpaque({ width, height, channels, pixels }: Picture, [u, v]: readonly number[]): boolean {
	const column = Math.min(width - 1, Math.max(0, Math.floor(u * width)));
	const row = Math.min(height - 1, Math.max(0, Math.floor(v * height)));
	return pixels[channels * (width * row + column) + 3] >= 128;
}

/** The silhouette without gaps narrower than about twice `reach` pixels: dilated, then eroded. */
export function closed(shares: Float32Array, pixels: number, reach: number): Uint8Array {
	const dark = Uint8Array.from(shares, (share) => (share >= 0.5 ? 1 : 0));
	return spread(spread(dark, pixels, reach, 1), pixels, reach, 0);
}

function spread(from: Uint8Array, pixels: number, reach: number, value: number): Uint8Array {
	const to = from.slice();
	for (let i = 0; i < from.length; i++) {
		if (from[i] !== value) continue;
		const [x, y] = [i % pixels, Math.floor(i / pixels)];
		for (let dy = -reach; dy <= reach; dy++)
			for (let dx = -reach; dx <= reach; dx++) {
				if (dx * dx + dy * dy > reach * reach) continue;
				const [column, row] = [x + dx, y + dy];
				if (column >= 0 && row >= 0 && column < pixels && row < pixels) to[pixels * row + column] = value;
			}
	}
	return to;
}

/** Intersection over union. */
export function overlap(one: Uint8Array, other: Uint8Array): number {
	let [both, either] = [0, 0];
	for (let i = 0; i < one.length; i++) {
		both += one[i] & other[i];
		either += one[i] | other[i];
	}
	return both / either;
}

/** The area of triangles that is opaque, square metres: by points of each triangle. */
export function opaqueArea(primitives: readonly Primitive[]): number {
	let sum = 0;
	for (const primitive of primitives)
		for (const corners of trianglesOf(primitive)) {
			const { uvs, cut } = primitive;
			const area = areaOf(corners.map((corner) => pointOf(primitive, corner)));
			let [opaque, count] = [0, 0];
			for (let i = 0; i < 16; i++)
				for (let j = 0; i + j < 16; j++) {
					const [wb, wc] = [(i + 0.33) / 16, (j + 0.33) / 16];
					count++;
					opaque += Number(!cut || isOpaque(cut, mixOf(uvs, corners, [1 - wb - wc, wb, wc])));
				}
			sum += (area * opaque) / count;
		}
	return sum;
}

/** The corners of each triangle. */
export function trianglesOf({ indices }: Primitive): number[][] {
	return Array.from({ length: indices.length / 3 }, (_, i) => [indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]]);
}

export function pointOf({ positions }: Primitive, vertex: number): number[] {
	return [positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]];
}

/** The area of a triangle, by its corners. */
function areaOf([a, b, c]: number[][]): number {
	const [u, v] = [b, c].map((corner) => corner.map((value, k) => value - a[k]));
	return 0.5 * Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

/** Parts as they are drawn: each instance by itself, turned by its quaternion. */
export function drawnParts(parts: readonly Part[]): Primitive[] {
	return parts.flatMap(({ shape, children = [] }): Primitive[] => {
		const own: Primitive[] = [];
		if (shape) {
			const { positions, indices } = shape.mesh;
			const plain = { material: shape.material.name, uvs: [], indices, attributes: {}, cut: undefined };
			const { transforms } = shape.instances ?? {};
			if (!transforms) own.push({ ...plain, positions });
			for (let at = 0; transforms && at < transforms.length; at += 8) {
				const [x, y, z, a, b, c, w, scale] = transforms.subarray(at, at + 8);
				const placed = new Float64Array(positions.length);
				for (let i = 0; i < positions.length; i += 3) {
					const [p, q, r] = positions.subarray(i, i + 3);
					// v + 2w (q × v) + 2 q × (q × v)
					const [s, t, u] = [2 * (b * r - c * q), 2 * (c * p - a * r), 2 * (a * q - b * p)];
					placed[i] = x + scale * (p + w * s + b * u - c * t);
					placed[i + 1] = y + scale * (q + w * t + c * s - a * u);
					placed[i + 2] = z + scale * (r + w * u + a * t - b * s);
				}
				own.push({ ...plain, positions: placed });
			}
		}
		return [...own, ...drawnParts(children)];
	});
}
