import { beforeAll, expect, it } from "vitest";
import { heightAt } from "../../../../web/src/models/stand/ground_grid";
import { groundParts } from "../../../../web/src/models/stand/parts";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import type { PartMesh } from "../../../../web/src/plant/part";
import { grownStand, planned } from "./stands";

let stand: StandPlant;
let soil: PartMesh;
let rim: Float32Array;
const place = (v: number) => [...soil.positions.subarray(3 * v, 3 * v + 3)] as [number, number, number];
beforeAll(async () => {
	const plan = planned("ground 2 x 1.2, relief 0.1\nplants 1, random\nflower/grass, crown 0.1 x 0.1");
	stand = await grownStand(plan, { meshes: true });
	const [ground] = groundParts(stand, { ...plan, look: { ...plan.look, soil: "6b5843" } });
	soil = ground.shape?.mesh as PartMesh;
	rim = stand.soil?.rim as Float32Array;
});

it("the ground reaches below all plants and slopes down in an irregular rim", () => {
	expect(rim).toHaveLength(soil.positions.length / 3);
	const reaches: number[] = [];
	for (const [v, share] of rim.entries()) {
		const [x, y, z] = place(v);
		const beyond = Math.hypot(Math.max(0, Math.abs(x) - 1), Math.max(0, Math.abs(z) - 0.6));
		if (share === 0) {
			expect(beyond).toBeLessThan(1e-6);
			expect(y).toBeCloseTo(heightAt(stand, x, z), 5);
			continue;
		}
		expect(beyond).toBeGreaterThan(0);
		expect(beyond).toBeLessThan(0.1);
		const edge = heightAt(stand, Math.max(-1, Math.min(1, x)), Math.max(-0.6, Math.min(0.6, z)));
		expect(y).toBeLessThan(edge);
		if (share === 1) reaches.push(beyond);
	}
	expect(Math.max(...reaches)).toBeGreaterThan(1.5 * Math.min(...reaches));
});

it("the rim goes all round: no edge is open but where all ends, and every triangle looks up", () => {
	const open = new Map<string, number[]>();
	for (let i = 0; i < soil.indices.length; i += 3) {
		const corners = [...soil.indices.subarray(i, i + 3)];
		const [[ax, , az], [bx, , bz], [cx, , cz]] = corners.map(place);
		expect((bz - az) * (cx - ax) - (bx - ax) * (cz - az)).toBeGreaterThan(0);
		for (let k = 0; k < 3; k++) {
			const edge = [corners[k], corners[(k + 1) % 3]];
			const back = `${edge[1]} ${edge[0]}`;
			if (!open.delete(back)) open.set(edge.join(" "), edge);
		}
	}
	expect(open.size).toBeGreaterThan(100);
	for (const edge of open.values()) for (const v of edge) expect(rim[v]).toBe(1);
});

it("soil is mottled around the requested colour", () => {
	const red = [...(soil.colours ?? [])].filter((_, i) => i % 3 === 0);
	const mean = red.reduce((sum, each) => sum + each, 0) / red.length;
	expect(mean).toBeGreaterThan(0.12);
	expect(mean).toBeLessThan(0.17);
	expect(Math.max(...red)).toBeGreaterThan(1.4 * Math.min(...red));
});
