/**
 * A small game tree with known numbers: a trunk and a crown of cards at three levels, wind data, a collision shape, and
 * an impostor, whose pictures are drawn here by their definition. As in the archives of trees, the first scene has the
 * finest level alone, the second one everything, and the last level is a picture.
 */
import { deflateSync } from "node:zlib";

/** Metres: height of the trunk, and the middle and half the edge of the impostor's pictures. */
const TRUNK = 4;
const CENTRE = [0, 3.4, 0];
const RADIUS = 4.2;
const FRAMES = 8;
const EDGE = 64;
const LEVELS = [
	{ sides: 12, cards: 240 },
	{ sides: 8, cards: 120 },
	{ sides: 5, cards: 40 },
];
const BARK = [110, 80, 55];
const LEAF = [60, 130, 40];

/** @typedef {{ positions: number[], normals: number[], uvs: number[], colours: number[], indices: number[] }} Mesh */

/** @returns {Mesh} */
const empty = () => ({ positions: [], normals: [], uvs: [], colours: [], indices: [] });

/** A tapering tube on the ground; only its upper end sways. */
function tube(sides, height, radius) {
	const mesh = empty();
	for (let j = 0; j <= 4; j++) {
		for (let i = 0; i <= sides; i++) {
			const turn = (2 * Math.PI * i) / sides;
			const at = radius * (1 - 0.175 * j);
			mesh.positions.push(at * Math.cos(turn), (height * j) / 4, at * Math.sin(turn));
			mesh.normals.push(Math.cos(turn), 0, Math.sin(turn));
			mesh.uvs.push(i / sides, j);
			mesh.colours.push(0, Math.round(5 * j * j), 0, 255);
		}
	}
	for (let j = 0; j < 4; j++) {
		for (let i = 0; i < sides; i++) {
			const [a, b] = [j * (sides + 1) + i, (j + 1) * (sides + 1) + i];
			mesh.indices.push(a, b, a + 1, a + 1, b, b + 1);
		}
	}
	return mesh;
}

/** Cards around the upper half of the trunk. */
function crown(count) {
	const mesh = empty();
	for (let k = 0; k < count; k++) {
		const [turn, out] = [2.399 * k, 1.8 * Math.sqrt((0.317 * k) % 1)];
		const [x, y, z] = [out * Math.cos(turn), 3 + 3 * ((0.618 * k) % 1), out * Math.sin(turn)];
		const edge = 0.5 * Math.sqrt(60 / count) + 0.1;
		const first = mesh.positions.length / 3;
		for (const [u, v] of [
			[-1, 0],
			[1, 0],
			[1, 2],
			[-1, 2],
		]) {
			mesh.positions.push(x + 0.5 * edge * u * Math.cos(turn), y + 0.5 * edge * v, z + 0.5 * edge * u * Math.sin(turn));
			mesh.normals.push(0.8 * Math.cos(turn), 0.6, 0.8 * Math.sin(turn));
			mesh.uvs.push(0.5 + 0.5 * u, 1 - 0.5 * v);
			mesh.colours.push(((94 * k) % 254) + 1, Math.round((255 * out) / 1.8), ((181 * k) % 254) + 1, 200);
		}
		mesh.indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
	}
	return mesh;
}

/** One card in place of the tree. */
function card() {
	const mesh = empty();
	for (const [x, y] of [
		[-1, 0],
		[1, 0],
		[1, 1],
		[-1, 1],
	]) {
		mesh.positions.push(2 * x, 6 * y, 0);
		mesh.normals.push(0, 0, 1);
		mesh.uvs.push(0.5 + 0.5 * x, 1 - y);
		mesh.colours.push(0, 0, 0, 255);
	}
	mesh.indices.push(0, 1, 2, 0, 2, 3);
	return mesh;
}

/** CRC-32 of PNG chunks, bit by bit. */
function crc(bytes) {
	let sum = ~0;
	for (const byte of bytes) {
		sum ^= byte;
		for (let bit = 0; bit < 8; bit++) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1;
	}
	return ~sum >>> 0;
}

/** A PNG of pixels with alpha. */
function png(width, height, pixels) {
	const chunk = (type, data) => {
		const body = Buffer.concat([Buffer.from(type), data]);
		const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
		length.writeUInt32BE(data.length);
		sum.writeUInt32BE(crc(body));
		return Buffer.concat([length, body, sum]);
	};
	const head = Buffer.alloc(13);
	head.writeUInt32BE(width, 0);
	head.writeUInt32BE(height, 4);
	head.set([8, 6], 8);
	const rows = Buffer.alloc(height * (1 + 4 * width));
	for (let y = 0; y < height; y++)
		rows.set(pixels.subarray(4 * width * y, 4 * width * (y + 1)), y * (1 + 4 * width) + 1);
	const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);
	return Buffer.concat([
		signature,
		chunk("IHDR", head),
		chunk("IDAT", deflateSync(rows)),
		chunk("IEND", Buffer.alloc(0)),
	]);
}

/** The picture of a leaf: a disc. */
function leafPicture() {
	const pixels = new Uint8Array(4 * 32 * 32);
	for (let i = 0; i < 32 * 32; i++) {
		const inside = Math.hypot((i % 32) - 15.5, Math.floor(i / 32) - 15.5) < 15;
		pixels.set([...LEAF, inside ? 255 : 0], 4 * i);
	}
	return png(32, 32, pixels);
}

/** Writes accessors and views of a GLB. */
class Writer {
	json = { asset: { version: "2.0" }, accessors: [], bufferViews: [], nodes: [], meshes: [] };
	#pieces = [];
	#length = 0;

	view(bytes) {
		const gap = Buffer.alloc((4 - (this.#length % 4)) % 4);
		this.#pieces.push(gap, bytes);
		this.json.bufferViews.push({ buffer: 0, byteOffset: this.#length + gap.length, byteLength: bytes.length });
		this.#length += gap.length + bytes.length;
		return this.json.bufferViews.length - 1;
	}

	accessor(array, type, size, more = {}) {
		const componentType = { Float32Array: 5126, Uint16Array: 5123, Uint8Array: 5121 }[array.constructor.name];
		const bufferView = this.view(Buffer.from(array.buffer));
		this.json.accessors.push({ bufferView, componentType, count: array.length / size, type, ...more });
		return this.json.accessors.length - 1;
	}

	primitive({ positions, normals, uvs, colours, indices }, material) {
		const of = (k) => positions.filter((_, i) => i % 3 === k);
		const [min, max] = [Math.min, Math.max].map((most) => [0, 1, 2].map((k) => Math.fround(most(...of(k)))));
		return {
			...(material === undefined ? {} : { material }),
			indices: this.accessor(Uint16Array.from(indices), "SCALAR", 1),
			attributes: {
				POSITION: this.accessor(Float32Array.from(positions), "VEC3", 3, { min, max }),
				NORMAL: this.accessor(Float32Array.from(normals), "VEC3", 3),
				TEXCOORD_0: this.accessor(Float32Array.from(uvs), "VEC2", 2),
				// The shade, and data for wind.
				COLOR_0: this.accessor(new Uint8Array(colours.length).fill(230), "VEC4", 4, { normalized: true }),
				COLOR_1: this.accessor(Uint8Array.from(colours), "VEC4", 4, { normalized: true }),
			},
		};
	}

	bytes() {
		const body = Buffer.concat([...this.#pieces, Buffer.alloc((4 - (this.#length % 4)) % 4)]);
		this.json.buffers = [{ byteLength: body.length }];
		const text = Buffer.from(JSON.stringify(this.json));
		const json = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, 32)]);
		const head = Buffer.alloc(20);
		head.write("glTF");
		for (const [at, value] of [2, 28 + json.length + body.length, json.length].entries())
			head.writeUInt32LE(value, 4 + 4 * at);
		head.write("JSON", 16);
		const bodyHead = Buffer.alloc(8);
		bodyHead.writeUInt32LE(body.length);
		bodyHead.write("BIN\0", 4);
		return Buffer.concat([head, json, bodyHead, body]);
	}
}

/** Direction of a picture in the grid. */
function directionOf(column, row) {
	const [u, v] = [(2 * column) / (FRAMES - 1) - 1, (2 * row) / (FRAMES - 1) - 1];
	const [x, z] = [0.5 * (u + v), 0.5 * (u - v)];
	const y = 1 - Math.abs(x) - Math.abs(z);
	return [x, y, z].map((value) => value / Math.hypot(x, y, z));
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** Draws the colour and the normals of meshes from all directions, nearest triangles last by a depth buffer. */
function impostor(meshes) {
	const width = FRAMES * EDGE;
	const [colour, surface] = [new Uint8Array(4 * width * width), new Uint8Array(4 * width * width)];
	const depths = new Float32Array(width * width).fill(Number.NEGATIVE_INFINITY);
	for (let row = 0; row < FRAMES; row++) {
		for (let column = 0; column < FRAMES; column++) {
			const towards = directionOf(column, row);
			const flat = cross([0, 1, 0], towards);
			const length = Math.hypot(...flat);
			const right = Math.abs(towards[1]) > 0.999 ? [1, 0, 0] : flat.map((value) => value / length);
			const up = cross(towards, right);
			/** Draws one triangle: pixels by their barycentric coordinates. */
			const draw = (mesh, corners, base) => {
				const places = corners.map((corner) => {
					const at = [0, 1, 2].map((k) => mesh.positions[3 * corner + k] - CENTRE[k]);
					const toPixel = (value) => 0.5 * EDGE * (1 + value / RADIUS);
					return [toPixel(dot(at, right)), EDGE - toPixel(dot(at, up)), dot(at, towards)];
				});
				const [[ax, ay], [bx, by], [cx, cy]] = places;
				const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
				if (Math.abs(area) < 1e-9) return;
				const bounds = (k, most) => Math.min(EDGE - 1, Math.max(0, Math.floor(most(...places.map((p) => p[k])))));
				for (let y = bounds(1, Math.min); y <= bounds(1, Math.max); y++) {
					for (let x = bounds(0, Math.min); x <= bounds(0, Math.max); x++) {
						const [px, py] = [x + 0.5, y + 0.5];
						const b = ((px - ax) * (cy - ay) - (cx - ax) * (py - ay)) / area;
						const c = ((bx - ax) * (py - ay) - (px - ax) * (by - ay)) / area;
						const shares = [1 - b - c, b, c];
						if (shares.some((share) => share < 0)) continue;
						const mix = (list, size, k) =>
							shares.reduce((sum, share, i) => sum + share * list[size * corners[i] + k], 0);
						const [u, v] = [mix(mesh.uvs, 2, 0), mix(mesh.uvs, 2, 1)];
						if (base === LEAF && Math.hypot(32 * u - 16, 32 * v - 16) >= 15) continue;
						const depth = shares.reduce((sum, share, i) => sum + share * places[i][2], 0);
						const at = (row * EDGE + y) * width + column * EDGE + x;
						if (depth <= depths[at]) continue;
						depths[at] = depth;
						colour.set([...base, 255], 4 * at);
						const facing = [0, 1, 2].map((k) => mix(mesh.normals, 3, k));
						const shown = [dot(facing, right), dot(facing, up), depth / RADIUS];
						surface.set(shown.map((value) => Math.round(127.5 * (1 + value))).concat(255), 4 * at);
					}
				}
			};
			for (const { mesh, base } of meshes)
				for (let i = 0; i < mesh.indices.length; i += 3) draw(mesh, mesh.indices.slice(i, i + 3), base);
		}
	}
	return { colour: png(width, width, colour), surface: png(width, width, surface) };
}

/**
 * Makes the files of the tree.
 * @returns {{ files: Map<string, Buffer>, height: number }} by their names; the height in metres
 */
export function smallTree() {
	const writer = new Writer();
	const { json } = writer;
	const linear = (rgb) => [...rgb.map((value) => (value / 255) ** 2.2), 1];
	json.images = [{ bufferView: writer.view(leafPicture()), mimeType: "image/png" }];
	json.textures = [{ source: 0 }];
	json.materials = [
		{ name: "Bark", pbrMetallicRoughness: { baseColorFactor: linear(BARK), metallicFactor: 0 } },
		{
			name: "Leaves",
			doubleSided: true,
			alphaMode: "MASK",
			alphaCutoff: 0.5,
			pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0 },
		},
	];
	const levels = LEVELS.map(({ sides, cards }) => [tube(sides, TRUNK, 0.3), crown(cards)]);
	for (const [level, meshes] of levels.entries()) {
		json.meshes.push({ primitives: meshes.map((mesh, material) => writer.primitive(mesh, material)) });
		json.nodes.push({ name: `Tree_LOD${level}`, mesh: level });
	}
	json.meshes.push({ primitives: [writer.primitive(card(), 1)] });
	json.nodes.push({ name: `Tree_LOD${levels.length}`, mesh: levels.length });
	json.meshes.push({ primitives: [writer.primitive(tube(6, TRUNK, 0.3))] });
	json.nodes.push({ name: "UCX_Tree_00", mesh: levels.length + 1 });
	json.scenes = [{ nodes: [0] }, { nodes: json.nodes.map((_, i) => i) }];
	json.scene = 0;
	const [trunk, leaves] = levels[0];
	const pictures = impostor([
		{ mesh: trunk, base: BARK },
		{ mesh: leaves, base: LEAF },
	]);
	const description = {
		levels: [0.25, 0.04, 0.005, 0].map((screenCoverage, i) => ({ name: `Tree_LOD${i}`, screenCoverage })),
		impostor: {
			frames: FRAMES,
			middle: CENTRE,
			radius: RADIUS,
			colour: "tree_Impostor.png",
			surface: "tree_Impostor_Surface.png",
		},
	};
	const files = new Map([
		["tree.glb", writer.bytes()],
		["tree.json", Buffer.from(JSON.stringify(description))],
		["tree_Impostor.png", pictures.colour],
		["tree_Impostor_Surface.png", pictures.surface],
	]);
	return { files, height: Math.max(...leaves.positions.filter((_, i) => i % 3 === 1)) };
}
