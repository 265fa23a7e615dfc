/**
 * Kinds of bark: height, colour and roughness at each point of a picture half a metre wide and a metre high.
 * Shapes and sizes: Vaucher, Tree Bark (2003).
 */
import { mix, smoothstep } from "../colour";
import { type BarkMarks, besideSeams, field, marks, ridge } from "./bark_noise";

/**
 * furrowed: long ridges that part and meet (oak, most trees). paper: pale, with lenticels across (birch). ringed: shallow
 * creases across (carrot). fibrous: strips along (roots, cypress, vine). smooth: hardly anything (beech). plated: plates
 * between deep cracks (pine). banded: smooth, with rows of lenticels across (cherry).
 */
export type BarkKind = "furrowed" | "paper" | "ringed" | "fibrous" | "smooth" | "plated" | "banded";

/** Size of the pictures. */
export const WIDTH = 256;
export const HEIGHT = 512;
/** Metres that a picture covers across and along: 512 pixels a metre. */
export const TILE: readonly [across: number, along: number] = [0.5, 1];

/** The bark at a point. */
export interface BarkPoint {
	/** Metres above an even surface. */
	height: number;
	/** Linear light, as shares of the bark's own colour. */
	red: number;
	green: number;
	blue: number;
	/** 0 mirror … 1 matt. */
	roughness: number;
}

/** Sets the bark at a point, u across and v along, each 0 … 1; `pixel` is the index of the pixel there. */
export type BarkPainter = (point: BarkPoint, u: number, v: number, pixel: number) => void;

/** Makes the painter of each kind. */
export const BARK_PAINTERS: Readonly<Record<BarkKind, () => BarkPainter>> = {
	/** Ridges 10–30 mm wide, 20–80 mm apart, between furrows 5–20 mm deep, broken across here and there; an oak's. */
	furrowed() {
		const [sway, broad, middle, narrow] = [field(8, 6, 1), field(12, 4, 2), field(20, 7, 3), field(40, 16, 4)];
		const [cracks, chips, tint] = [field(24, 22, 5), field(48, 40, 6), field(8, 5, 9)];
		const [grain, streaks] = [field(96, 128, 7), field(84, 24, 8)];
		return (point, u, v) => {
			const x = u + 0.035 * besideSeams(u) * (sway(u, v) - 0.5);
			const large = ridge(0.66 * broad(x, v) + 0.34 * middle(x, v));
			// Ridged multifractal noise (Musgrave 1994): finer ridges are on ridges, and furrows remain clean.
			const rise = smoothstep(0.02, 0.3, large + 0.06 * (chips(x, v) - 0.5));
			const small = smoothstep(0, 0.45, ridge(narrow(x, v)));
			// Ridges are broken across where noise is low.
			const whole = smoothstep(0.22, 0.34, cracks(x, v) + 0.2 * (chips(u, v) - 0.5));
			const streak = streaks(x, v);
			const top = rise * (0.66 + 0.34 * small) * (0.66 + 0.34 * whole);
			const fine = grain(u, v) - 0.5;
			point.height = 0.011 * top + 0.0012 * fine + 0.0014 * (streak - 0.5) * rise;
			const lit = 0.16 + 0.84 * top * (0.8 + 0.32 * streak) + 0.2 * fine * (0.4 + 0.6 * top);
			// Furrows are browner, ridges greyer, with a green bloom of algae in places.
			const brown = 1 - top;
			const algae = smoothstep(0.5, 0.85, tint(u, v)) * top;
			point.red = lit * (1 + 0.12 * brown - 0.07 * algae);
			point.green = lit * (1 - 0.02 * brown + 0.02 * algae);
			point.blue = lit * (1 - 0.2 * brown - 0.12 * algae);
			point.roughness = 0.96 - 0.08 * top;
		};
	},

	/** Papery bark: lenticels 10–60 × 2–4 mm across, edges of peeling sheets, and a few dark marks; a birch's. */
	paper() {
		const [cloud, bands, hairs] = [field(12, 7, 11), field(12, 40, 12), field(16, 220, 13)];
		const edges = stamped({ count: 26, width: [0.06, 0.22], height: [0.0007, 0.0016], stream: 14 });
		const lenticels = stamped({ count: 120, width: [0.02, 0.12], height: [0.002, 0.0038], stream: 16 });
		const scars = stamped({ count: 6, width: [0.06, 0.15], height: [0.007, 0.016], stream: 17 });
		return (point, u, v, pixel) => {
			const wave = v + 0.01 * (cloud(u, v) - 0.5);
			const lenticel = lenticels[pixel];
			const scar = scars[pixel];
			const edge = edges[pixel];
			const stain = smoothstep(0.5, 0.95, bands(u, wave)) * smoothstep(0.3, 0.8, cloud(u, v));
			const fresh = 0.94 + 0.06 * cloud(u, v) - 0.05 * hairs(u, wave) - 0.1 * stain;
			const dark = Math.min(1, Math.max(0.8 * lenticel, 1.15 * scar, 0.6 * edge));
			point.height =
				0.0012 * lenticel - 0.0015 * edge - 0.002 * scar + 0.0003 * hairs(u, wave) + 0.0005 * bands(u, wave);
			point.red = fresh * (1 - dark) + 0.012 * dark;
			point.green = (fresh - 0.025 * stain) * (1 - dark) + 0.01 * dark;
			point.blue = (fresh - 0.06 * stain) * (1 - dark) + 0.008 * dark;
			point.roughness = 0.62 + 0.3 * dark;
		};
	},

	/** Creases around the root that are interrupted; a carrot's. */
	ringed() {
		const [wave, creases, reach, cloud] = [field(8, 3, 21), field(8, 22, 22), field(8, 9, 23), field(8, 5, 24)];
		return (point, u, v) => {
			const y = v + 0.012 * (wave(u, v) - 0.5);
			const crease = smoothstep(0.1, 0, ridge(creases(u, y))) * smoothstep(0.35, 0.75, reach(u, v));
			grey(point, 0.9 + 0.1 * cloud(u, v) - 0.32 * crease, 0.85);
			point.height = -0.0025 * crease;
		};
	},

	/** Strips along the stem that lift at their edges; a cypress's, a vine's, a root's. */
	fibrous() {
		const [sway, strips, fibres, threads] = [field(8, 5, 31), field(24, 3, 32), field(52, 7, 33), field(120, 16, 34)];
		const [ends, tint] = [field(16, 12, 35), field(12, 4, 36)];
		return (point, u, v) => {
			const x = u + 0.02 * besideSeams(u) * (sway(u, v) - 0.5);
			const strip = smoothstep(0, 0.3, ridge(strips(x, v)));
			const fibre = smoothstep(0, 0.6, ridge(fibres(x, v)));
			const thread = threads(x, v);
			const rise = strip * (0.6 + 0.4 * fibre) * (0.8 + 0.2 * smoothstep(0.3, 0.5, ends(x, v)));
			point.height = 0.005 * rise + 0.0012 * thread;
			const lit = 0.3 + 0.56 * rise + 0.16 * thread;
			const warm = tint(u, v) - 0.5;
			point.red = lit * (1.02 + 0.12 * warm);
			point.green = lit;
			point.blue = lit * (0.96 - 0.16 * warm - 0.1 * (1 - rise));
			point.roughness = 0.93;
		};
	},

	/** Almost even bark with fine wrinkles across and pale crusts of lichen; a beech's. */
	smooth() {
		const [cloud, mottles, wrinkles, grain] = [
			field(8, 5, 41),
			field(16, 20, 42),
			field(20, 130, 43),
			field(120, 200, 44),
		];
		const [lichen, edges] = [field(12, 22, 45), field(48, 80, 46)];
		const pores = stamped({ count: 260, width: [0.006, 0.014], height: [0.0016, 0.003], stream: 47 });
		return (point, u, v, pixel) => {
			const wave = v + 0.006 * (mottles(u, v) - 0.5);
			const crust = smoothstep(0.72, 0.78, lichen(u, v) + 0.14 * (edges(u, v) - 0.5));
			const wrinkle = wrinkles(u, wave);
			const pore = pores[pixel];
			const lit =
				0.78 +
				0.1 * cloud(u, v) +
				0.07 * mottles(u, v) +
				0.03 * wrinkle +
				0.03 * grain(u, v) +
				0.07 * crust -
				0.1 * pore;
			point.height = 0.0007 * mottles(u, v) + 0.0005 * wrinkle + 0.0006 * pore + 0.0003 * crust;
			point.red = lit * (1 + 0.02 * (mottles(u, v) - 0.5));
			point.green = lit * (1 + 0.012 * crust);
			point.blue = lit * (1 - 0.03 * (cloud(u, v) - 0.5));
			point.roughness = 0.74 + 0.1 * crust;
		};
	},

	/** Plates 4–8 cm wide between deep cracks, of thin layers; a pine's. */
	plated() {
		const [sway, long, longer, across] = [field(12, 14, 51), field(12, 4, 52), field(20, 7, 53), field(12, 13, 54)];
		const [flakes, layers, tint, grain] = [field(40, 64, 55), field(16, 22, 56), field(12, 9, 57), field(96, 160, 58)];
		return (point, u, v) => {
			const shift = sway(u, v) - 0.5;
			const x = u + 0.04 * besideSeams(u) * shift;
			const flake = flakes(u, v);
			const jag = 0.1 * (flake - 0.5);
			const side = smoothstep(0.02, 0.17, ridge(0.62 * long(x, v) + 0.38 * longer(x, v)) + jag);
			const end = smoothstep(0.0, 0.13, ridge(across(u, v + 0.02 * shift)) + jag);
			const plate = side * (0.4 + 0.6 * end);
			const fine = grain(u, v) - 0.5;
			// Thin layers end in steps, like the terraces of a map.
			const depth = 5 * (0.62 * layers(x, v) + 0.38 * flake);
			const under = depth - Math.floor(depth);
			const step = Math.floor(depth) + smoothstep(0.8, 1, under);
			const lip = smoothstep(0.6, 0.85, under) * smoothstep(1, 0.9, under) * plate;
			point.height = 0.011 * plate + 0.0009 * step * plate + 0.0012 * fine;
			const lit = 0.15 + plate * (0.46 + 0.07 * step + 0.16 * tint(x, v)) - 0.16 * lip + 0.16 * fine;
			// Grey outer layers over orange inner ones.
			const orange = smoothstep(0.35, 0.75, 0.5 * under + 0.5 * tint(x, v)) * plate;
			point.red = lit * (1 + 0.18 * orange);
			point.green = lit * (1 - 0.03 * orange);
			point.blue = lit * (1 - 0.22 * orange - 0.14 * (1 - plate));
			point.roughness = 0.94 - 0.1 * plate;
		};
	},

	/** Smooth, shining bark with corky lenticels 10–50 mm long in rows across, and bands that peel; a cherry's. */
	banded() {
		const [cloud, bands, hairs, peel] = [field(12, 6, 61), field(4, 22, 62), field(16, 200, 63), field(12, 12, 64)];
		const rows = stamped({ count: 170, width: [0.02, 0.1], height: [0.003, 0.0055], rows: 22, stream: 65 });
		const loose = stamped({ count: 90, width: [0.012, 0.04], height: [0.002, 0.0035], stream: 66 });
		return (point, u, v, pixel) => {
			const wave = v + 0.03 * (cloud(u, v) - 0.5);
			const band = smoothstep(0.35, 0.65, bands(u, wave));
			const cork = Math.max(rows[pixel], 0.8 * loose[pixel]);
			const edge = smoothstep(0.04, 0.008, ridge(bands(u, wave))) * smoothstep(0.55, 0.7, peel(u, v));
			const lit = 0.46 + 0.14 * band + 0.1 * cloud(u, v) + 0.06 * hairs(u, wave) - 0.2 * edge;
			point.height = 0.0022 * cork + 0.0006 * band + 0.0002 * hairs(u, wave) - 0.0008 * edge;
			// Cork is dull and ochre, and lighter than the bark.
			point.red = mix(lit, 0.86, cork);
			point.green = mix(lit * (0.97 + 0.03 * band), 0.7, cork);
			point.blue = mix(lit * (0.96 + 0.04 * band), 0.5, cork);
			point.roughness = 0.5 + 0.4 * cork + 0.1 * (1 - band);
		};
	},
};

/** Returns marks as a picture of the size of all pictures. */
function stamped(of: BarkMarks): Float32Array {
	return marks(of, WIDTH, HEIGHT);
}

/** Sets a grey of a lightness in sRGB. */
function grey(point: BarkPoint, lightness: number, roughness: number): void {
	const light = lightness ** 2.2;
	point.red = light;
	point.green = light;
	point.blue = light;
	point.roughness = roughness;
}
