import { DoubleSide, FrontSide } from "three";
import { describe, expect, it } from "vitest";
import type { Material } from "../../../web/src/plant/material";
import { standardMaterial } from "../../../web/src/scene/standard_material";

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

describe("standardMaterial", () => {
	it("has every value of ours that three's has a place for", () => {
		const made = standardMaterial(rich, false);
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

	it("leaves colour to the vertices where they have it, and costly lobes out where there are none", () => {
		const made = standardMaterial({ name: "Plain", colour: [0.4, 0.2, 0.1], roughness: 1 }, true);
		expect(made.color.toArray()).toEqual([1, 1, 1]);
		expect([made.vertexColors, made.side, made.sheen, made.clearcoat, made.transmission]).toEqual([
			true,
			FrontSide,
			0,
			0,
			0,
		]);
	});
});
