import { beforeEach, describe, expect, it, vi } from "vitest";
import {
	fitted,
	middleOf,
	nudged,
	type Photo,
	pinched,
	shifted,
	zoomed,
} from "../../../../../web/src/models/bunch/photo/photo";
import { placePhoto } from "../../../../../web/src/models/bunch/photo/place_photo";
import { changePhoto, photo, removePhoto } from "../../../../../web/src/models/bunch/ui/photo";
import { bunchContext, studioWith } from "../../../app/context";
import { specimenFromPreset } from "../../../bunch";

vi.mock("../../../../../web/src/models/bunch/photo/photo_view", () => ({}));

const picture = () => ({ width: 400, height: 800, close: vi.fn() }) as unknown as ImageBitmap;
const placed: Photo = { picture: picture(), view: "front", opacity: 0.5, loose: true, x: -100, y: 0, scale: 0.5 };
const key = (name: string, shiftKey = false) => nudged(placed, { key: name, shiftKey });

describe("a photograph's place", () => {
	it("is at first the bunch's height, in the middle", () => {
		const place = fitted({ width: 400, height: 800 }, 480);
		expect(place).toEqual({ x: -120, y: 0, scale: 0.6 });
		expect(middleOf({ ...place, picture: placed.picture })).toEqual({ x: 0, y: 240 });
	});

	it("is moved by arrow keys, ten times as far with Shift", () => {
		expect(key("ArrowRight")).toEqual({ x: -99, y: 0, scale: 0.5 });
		expect(key("ArrowUp", true)).toEqual({ x: -100, y: -10, scale: 0.5 });
		expect(key("a")).toBeUndefined();
	});

	it("is scaled by plus and minus about its middle, and back", () => {
		const larger = { ...placed, ...key("+") };
		expect(larger.scale).toBeCloseTo(0.505);
		expect(middleOf(larger)).toEqual(middleOf(placed));
		expect(nudged(larger, { key: "-", shiftKey: false })?.scale).toBeCloseTo(0.5);
	});

	it("keeps the point under the pointer in place when scaled, within limits", () => {
		const about = { x: 30, y: 90 };
		const under = ({ x, y, scale }: Pick<Photo, "x" | "y" | "scale">) => [(about.x - x) / scale, (about.y - y) / scale];
		const larger = zoomed(placed, 1.7, about);
		expect(larger.scale).toBeCloseTo(0.85);
		under(larger).forEach((value, i) => {
			expect(value).toBeCloseTo(under(placed)[i]);
		});
		expect(zoomed(placed, 1e9, about).scale * 800).toBeCloseTo(6000);
		expect(zoomed(placed, 1e-9, about).scale * 800).toBeCloseTo(20);
	});

	it("follows two fingers", () => {
		const from = [
			{ x: 0, y: 0 },
			{ x: 100, y: 0 },
		] as const;
		const to = [
			{ x: 10, y: 5 },
			{ x: 210, y: 5 },
		] as const;
		expect(pinched(placed, from, to)).toEqual({ ...shifted({ x: -200, y: 0, scale: 1 }, { x: 10, y: 5 }) });
		expect(pinched(placed, [from[0], from[0]], to).scale).toBe(0.5);
	});
});

describe("the photograph's tool", () => {
	const bitmaps = vi.fn();
	beforeEach(() => {
		bitmaps.mockReset();
		vi.stubGlobal("createImageBitmap", bitmaps);
	});

	it("places a picture behind the front view, which survives undo, is in no link, and can be removed", async () => {
		const { studio, services } = await studioWith(specimenFromPreset());
		const context = bunchContext(studio);
		const first = picture();
		bitmaps.mockResolvedValue(first);
		await placePhoto(context, new Blob());
		expect(context.toolState(photo)).toMatchObject({ picture: first, view: "front", loose: true, y: 0 });
		context.set({ parameters: { l: 300 } });
		studio.undo();
		expect(context.toolState(photo)?.picture).toBe(first);
		expect(JSON.stringify(services.settled.mock.calls)).not.toContain("picture");
		changePhoto(context, { view: "side", opacity: 0.3 });
		const second = picture();
		bitmaps.mockResolvedValue(second);
		await placePhoto(context, new Blob());
		expect(first.close).toHaveBeenCalled();
		expect(context.toolState(photo)).toMatchObject({ picture: second, view: "side" });
		removePhoto(context);
		expect(second.close).toHaveBeenCalled();
		expect(context.toolState(photo)).toBeUndefined();
		changePhoto(context, { opacity: 1 });
		expect(context.toolState(photo)).toBeUndefined();
	});

	it("keeps a large picture smaller", async () => {
		const { studio } = await studioWith(specimenFromPreset());
		const large = { width: 8000, height: 4000, close: vi.fn() };
		bitmaps.mockImplementation(async (_, resize) =>
			resize ? { width: resize.resizeWidth, height: resize.resizeHeight, close: vi.fn() } : large,
		);
		await placePhoto(bunchContext(studio), new Blob());
		expect(bunchContext(studio).toolState(photo)?.picture).toMatchObject({ width: 2000, height: 1000 });
		expect(large.close).toHaveBeenCalled();
	});

	it("reports an invalid file", async () => {
		const { studio } = await studioWith(specimenFromPreset());
		bitmaps.mockRejectedValue(new Error("not decodable"));
		await placePhoto(bunchContext(studio), new Blob());
		expect(studio.state.notices).toMatchObject([
			{
				title: "The photo could not be used",
				details: ["The file is not a picture that this browser can read. Use a JPEG, PNG or WebP."],
			},
		]);
		expect(bunchContext(studio).toolState(photo)).toBeUndefined();
	});

	it.each([
		["bunch.JPG", "", true],
		["bunch", "image/png", true],
		["bunch.glb", "", false],
	])("takes %s (%s): %s", (name, type, takes) => {
		expect(photo.drop?.takes(new File([], name, { type }))).toBe(takes);
	});
});
