import {
	ClampToEdgeWrapping,
	DoubleSide,
	FrontSide,
	MeshPhysicalMaterial,
	RepeatWrapping,
	ShaderLib,
	Texture,
	type WebGLProgramParametersWithUniforms,
} from "three";
import { describe, expect, it } from "vitest";
import type { Material } from "../../../web/src/plant/material";
import { lightUniforms } from "../../../web/src/render/light_shader";
import {
	crownUniforms,
	type StandardOptions,
	setPicture,
	setSheet,
	standardMaterial,
} from "../../../web/src/render/standard_material";

const rich: Material = {
	name: "Skin",
	colour: [0.4, 0.2, 0.1],
	roughness: 0.3,
	doubleSided: true,
	sheen: { colour: [0.1, 0.2, 0.3], roughness: 0.6 },
	ior: 1.4,
	specular: 0.7,
	clearcoat: { factor: 0.9, roughness: 0.05 },
};

const light = lightUniforms();

/** The program that three.js would receive. */
function programOf(material: Material, options: Omit<StandardOptions, "light">) {
	const { vertexShader, fragmentShader } = ShaderLib.physical;
	const shader = { vertexShader, fragmentShader, uniforms: {} } as unknown as WebGLProgramParametersWithUniforms;
	standardMaterial(material, { light, ...options }).onBeforeCompile(shader, undefined as never);
	return shader;
}

describe("standardMaterial", () => {
	it("copies every value that three's material supports", () => {
		const made = standardMaterial(rich, { light }) as MeshPhysicalMaterial;
		expect(made.color.toArray()).toEqual([0.4, 0.2, 0.1]);
		expect(made.sheenColor.toArray()).toEqual([0.1, 0.2, 0.3]);
		expect(made).toMatchObject({
			name: "Skin",
			side: DoubleSide,
			vertexColors: false,
			metalness: 0,
			roughness: 0.3,
			sheen: 1,
			sheenRoughness: 0.6,
			specularIntensity: 0.7,
			clearcoat: 0.9,
			clearcoatRoughness: 0.05,
		});
		expect(made.ior).toBeCloseTo(1.4, 9);
	});

	it("leaves colour to vertices that have it, and omits unused costly lobes", () => {
		const made = standardMaterial({ name: "Plain", colour: [0.4, 0.2, 0.1], roughness: 1 }, { light, coloured: true });
		expect(made.color.toArray()).toEqual([1, 1, 1]);
		expect([made.vertexColors, made.side, made instanceof MeshPhysicalMaterial]).toEqual([true, FrontSide, false]);
	});

	it("darkens the surroundings by the sky, and the lamps by their shares, if these are known", () => {
		const plain: Material = { name: "Plain", colour: [1, 1, 1], roughness: 1 };
		const bare = programOf(plain, {});
		expect(bare.fragmentShader).not.toContain("openSky");
		expect(bare.uniforms.glossLobes).toBe(light.glossLobes);
		const open = programOf(plain, { sky: true });
		expect(open.vertexShader).toMatch(/attribute float sky;[\s\S]*openSky = sky;/);
		expect(open.fragmentShader).toContain("indirectDiffuse *= bounced(openSky");
		const passing = { value: 3 };
		const chunk = "vec2 lamp_shares(vec3 point) { return vec2(passing); }";
		const shaded = programOf(plain, { shares: { chunk, uniforms: { passing } } });
		expect(shaded.vertexShader).toContain("lampShares = lamp_shares(standing.xyz);");
		expect(shaded.fragmentShader).toMatch(
			/getDirectionalLightInfo[\s\S]*directLight\.color \*= UNROLLED_LOOP_INDEX == 0/,
		);
		expect(shaded.uniforms.passing).toBe(passing);
	});

	it("transmits light through sheets, and colours their reverse side, which can change", () => {
		const sheet: Material = { ...rich, sheet: { through: [0.75, 0.5, 0.25], reverse: [2, 3, 4] } };
		const { fragmentShader, uniforms } = programOf(sheet, {});
		expect(fragmentShader).toContain("sheetThrough * sqrt(diffuseColor.rgb)");
		expect(fragmentShader).toContain("if (!gl_FrontFacing) diffuseColor.rgb *= sheetReverse");
		expect(uniforms.sheetThrough.value.toArray()).toEqual([0.75, 0.5, 0.25]);
		expect(programOf(rich, {}).fragmentShader).not.toContain("sheet");
		const made = standardMaterial(sheet, { light });
		setSheet(made, { ...sheet, sheet: { through: [0, 0, 0], reverse: [1, 1, 1] } });
		expect(made.userData.sheet.sheetReverse.value.toArray()).toEqual([1, 1, 1]);
	});

	it("transmits the light of a lamp only where the other side is not in its shadow", () => {
		const sheet = { ...rich, sheet: { through: [1, 1, 1], reverse: [1, 1, 1] } } satisfies Material;
		const { vertexShader, fragmentShader } = programOf(sheet, { sky: true });
		const [shadow, behind] = ["getShadow( directionalShadowMap", "lampsBehind += directLight.color"].map((text) =>
			fragmentShader.indexOf(text),
		);
		expect(shadow).toBeGreaterThan(0);
		expect(behind).toBeGreaterThan(shadow);
		expect(fragmentShader.split("lampsBehind += directLight.color")).toHaveLength(2);
		// A leaf lit from behind is not in its own shadow.
		expect(vertexShader).toContain("shadowWorldNormal *= dot(shadowWorldNormal, keyDirection)");
	});

	it("bends the normals of sheets outwards from a crown, and leaves those of wood", () => {
		const crown = crownUniforms();
		const sheet = { ...rich, sheet: { through: [1, 1, 1], reverse: [1, 1, 1] } } satisfies Material;
		const bent = programOf(sheet, { crown });
		expect(bent.fragmentShader).toContain("normal = normalize(mix(normal, crownOut, 0.5));");
		expect(bent.uniforms.crownCentre).toBe(crown.crownCentre);
		expect(programOf(rich, { crown }).fragmentShader).not.toContain("crownOut");
	});

	it("widens tubes that are thinner than a pixel, after the position is projected", () => {
		const { vertexShader } = programOf({ name: "Bark", colour: [1, 1, 1], roughness: 1 }, { thin: true });
		expect(vertexShader).toContain("attribute float width;");
		expect(vertexShader.indexOf("float lacking")).toBeGreaterThan(vertexShader.indexOf("#include <project_vertex>"));
		expect(programOf(rich, {}).vertexShader).not.toContain("lacking");
	});

	it("shows a material's picture in place of its colour, until the picture changes", () => {
		const colour = { width: 2, height: 1, pixels: Uint8Array.of(10, 20, 30, 40, 50, 60) };
		const made = standardMaterial({ ...rich, textures: { colour } }, { light });
		expect(made.color.toArray()).toEqual([1, 1, 1]);
		const first = made.map;
		expect(first?.image).toMatchObject({ data: Uint8Array.of(10, 20, 30, 255, 40, 50, 60, 255) });
		expect(first).toMatchObject({ flipY: false, colorSpace: "srgb" });
		let gone = 0;
		first?.addEventListener("dispose", () => gone++);
		setPicture(made, { ...rich, textures: { colour } });
		expect([made.map, gone]).toEqual([first, 0]);
		setPicture(made, { ...rich, textures: { colour: { ...colour } } });
		expect(made.map).not.toBe(first);
		expect(gone).toBe(1);
		setPicture(made, rich);
		expect(made.map).toBeNull();
	});

	it("uses the given texture for its picture, and makes no other", () => {
		const colour = { width: 1, height: 1, pixels: Uint8Array.of(10, 20, 30) };
		const map = new Texture();
		const made = standardMaterial({ ...rich, textures: { colour } }, { light, maps: { colour: map } });
		expect(made.map).toBe(map);
	});

	it("repeats a picture only if requested", () => {
		const picture = { width: 1, height: 1, pixels: Uint8Array.of(1, 2, 3) };
		const wrapOf = (repeats?: boolean) =>
			standardMaterial({ ...rich, textures: { colour: picture, repeats } }, { light }).map?.wrapT;
		expect(wrapOf(true)).toBe(RepeatWrapping);
		expect(wrapOf()).toBe(ClampToEdgeWrapping);
	});

	it("shares programs between materials of the same features only", () => {
		const key = (options: Omit<StandardOptions, "light">) =>
			standardMaterial(rich, { light, ...options }).customProgramCacheKey();
		expect(key({ sky: true })).toBe(key({ sky: true, coloured: true }));
		expect(key({ sky: true })).not.toBe(key({}));
	});
});
