import { expect, it } from "vitest";
import { gridOf, heightAt, interpolate } from "../../../../web/src/models/stand/ground_grid";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";

/** Three cells by two, 6 × 2 m, that bulges in the middle of its left. */
const ACROSS = 3;
const DEEP = 2;
const HEIGHTS = [0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 3];
const positions = Float32Array.from(
	HEIGHTS.flatMap((y, i) => [(i % (ACROSS + 1)) * 2 - 3, y, Math.floor(i / (ACROSS + 1)) - 1]),
);
const stand = { ground: { width: 6, depth: 2, relief: 3 }, meshes: [{ positions }] } as unknown as StandPlant;

it("derives the number of cells from the vertices", () => {
	expect(gridOf({ positions })).toEqual({ across: ACROSS, deep: DEEP });
});

it("interpolates linearly between vertices, and exactly at each, the last included", () => {
	const grid = gridOf({ positions });
	const at = (u: number, v: number) => interpolate(grid, HEIGHTS, [1, 0], u, v);
	expect([at(1, 1), at(0.5, 1), at(1, 0.25), at(1.5, 0.5), at(ACROSS, DEEP)]).toEqual([1, 0.5, 0.25, 0.25, 3]);
	expect(interpolate(grid, positions, [3, 0], 1.5, 0.5)).toBe(0);
});

it("returns heights in metres, and beyond the ground that of its edge", () => {
	expect([heightAt(stand, -1, 0), heightAt(stand, -2, 0), heightAt(stand, 3, 1)]).toEqual([1, 0.5, 3]);
	expect([heightAt(stand, 30, 10), heightAt(stand, -30, 0)]).toEqual([3, 0]);
	expect(heightAt({ ...stand, meshes: [] }, 0, 0)).toBe(0);
});
