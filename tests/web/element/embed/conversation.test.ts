import fc from "fast-check";
import { beforeEach, describe, expect, it, vi } from "vitest";
import { Conversation, type EmbeddedPlant, PROTOCOL } from "../../../../web/src/element/embed/conversation";
import { FRAME_KEYS, frameSettings } from "../../../../web/src/element/embed/frame_settings";
import { modelNamed, modelNames } from "../../../../web/src/models/index";
import { isKnown } from "../../../../web/src/specimen/restore";

const HOST = "https://host.example";
const grown = { link: "?v=2" } as never;
let plant: { [Key in keyof EmbeddedPlant]: Key extends "specimen" ? unknown : ReturnType<typeof vi.fn> };
const source = { postMessage: vi.fn() };
beforeEach(() => {
	source.postMessage.mockReset();
	plant = {
		specimen: { preset: "merlot" },
		set: vi.fn(async () => grown),
		open: vi.fn(async () => grown),
		grow: vi.fn(async () => grown),
		toFile: vi.fn(async () => "file"),
		toBlob: vi.fn(async () => "picture"),
		resetView: vi.fn(),
	};
});

async function answersTo(message: object, { allowed, origin = HOST }: { allowed?: string[]; origin?: string } = {}) {
	const conversation = new Conversation(plant as unknown as EmbeddedPlant, allowed);
	await conversation.receive({ data: { panicle: PROTOCOL, id: 1, ...message }, origin, source });
	return { conversation, answers: source.postMessage.mock.calls };
}
const answered = (more: object, origin = HOST) => [[{ panicle: PROTOCOL, id: 1, ...more }, { targetOrigin: origin }]];

describe("a host page's request", () => {
	it.each([
		[{ method: "specimen" }, { preset: "merlot" }],
		[{ method: "grow" }, grown],
		[{ method: "set", values: { age: 60, skin: "ff0000" } }, grown],
		[{ method: "open", values: { link: "?v=2" } }, grown],
		[{ method: "file", values: { format: "glb-low", triangles: 900 } }, "file"],
		[{ method: "picture", values: { width: 40.4, height: 60 } }, "picture"],
		[{ method: "reset" }, undefined],
	])("%j gets a response to its origin only", async (message, result) => {
		expect((await answersTo(message)).answers).toEqual(answered({ result }));
	});

	it("passes the values to the plant", async () => {
		await answersTo({ method: "set", values: { age: 60, skin: "ff0000" } });
		await answersTo({ method: "file", values: { format: "glb-low", triangles: 900, other: 1 } });
		await answersTo({ method: "picture", values: { width: 40.4 } });
		await answersTo({ method: "open", values: { link: "?v=2&seed=3" } });
		expect(plant.set).toHaveBeenCalledWith({ age: 60, skin: "ff0000" });
		expect(plant.toFile).toHaveBeenCalledWith("glb-low", { triangles: 900 });
		expect(plant.toBlob).toHaveBeenCalledWith({ width: 40 });
		expect(plant.open).toHaveBeenCalledWith("?v=2&seed=3");
	});

	it.each([
		[{ method: "constructor" }, /^There is no method "constructor"\. The methods are listen, specimen/],
		[{ method: 7 }, /^There is no method 7/],
		[{ method: "set", values: [1] }, /^“values” must be an object/],
		[{ method: "set", values: { age: [60] } }, /^age must be text/],
		[{ method: "set", values: { age: Number.NaN } }, /^age must be a number/],
		[
			{ method: "set", values: Object.fromEntries(Array.from({ length: 300 }, (_, i) => [`k${i}`, 1])) },
			/more than 200 entries/,
		],
		[{ method: "open", values: {} }, /^link must be text/],
		[{ method: "picture", values: { width: 1e6 } }, /^width must be from 1 to 8,192 pixels/],
		[{ method: "file", values: { format: "glb", triangles: "many" } }, /^triangles must be a whole number/],
		[{ method: "file", values: { format: "stl", thickness: 0.001 } }, /^thickness must be a number from 0.2 to 20\.$/],
		[
			{ method: "file", values: { format: "ply", points: 1e12 } },
			/^points must be a whole number from 1 to 2,000,000\.$/,
		],
		[
			{ method: "file", values: { format: "glb-low", triangles: -1 } },
			/^triangles must be a whole number from 100 to 2,000,000\.$/,
		],
	])("%j gets an error message", async (message, error) => {
		const { answers } = await answersTo(message);
		const code = expect.stringMatching(/^(element|formats)\./);
		expect(answers).toEqual(answered({ error: expect.stringMatching(error), code, args: expect.anything() }));
	});

	it("reports the error", async () => {
		plant.grow.mockRejectedValueOnce(new Error("no room"));
		expect((await answersTo({ method: "grow" })).answers).toEqual(answered({ error: "no room", code: "", args: {} }));
	});

	it("is accepted from allowed origins only, if the frame names some", async () => {
		const other = await answersTo({ method: "set", values: { age: 1 } }, { allowed: ["https://other.example"] });
		expect(other.answers).toEqual(
			answered({
				error: `Pages from ${HOST} may not send requests to this frame. Add the origin to the frame’s settings.`,
				code: "element.embed_origin_refused",
				args: { origin: HOST },
			}),
		);
		expect(plant.set).not.toHaveBeenCalled();
		source.postMessage.mockReset();
		expect((await answersTo({ method: "specimen" }, { allowed: [HOST] })).answers).toHaveLength(1);
	});

	it("gets no response for a page without an origin", async () => {
		expect((await answersTo({ method: "grow" }, { origin: "null" })).answers).toEqual([]);
		expect(plant.grow).not.toHaveBeenCalled();
	});

	it("sends events to listening windows, at their origins", async () => {
		const { conversation } = await answersTo({ method: "listen" });
		conversation.broadcast("grown", grown);
		const message = { panicle: PROTOCOL, event: "grown", detail: grown };
		expect(source.postMessage.mock.calls[1]).toEqual([message, { targetOrigin: HOST }]);
	});

	it("serves at most 64 listening windows, drops closed ones, and refuses one more with an error", async () => {
		const conversation = new Conversation(plant as unknown as EmbeddedPlant);
		const windows = Array.from({ length: 65 }, () => ({ postMessage: vi.fn(), closed: false }));
		const listen = (source: (typeof windows)[number]) =>
			conversation.receive({ data: { panicle: PROTOCOL, id: 1, method: "listen" }, origin: HOST, source });
		for (const source of windows) await listen(source);
		const results = windows.map(({ postMessage }) => postMessage.mock.lastCall?.[0]);
		expect(results.slice(0, 64).every(({ result }) => result === true)).toBe(true);
		expect(results[64].error).toMatch(/^64 windows are already connected/);
		// A window that listens already may send the request again.
		await listen(windows[0]);
		expect(windows[0].postMessage.mock.lastCall?.[0]).toMatchObject({ result: true });
		windows[1].closed = true;
		await listen(windows[64]);
		expect(windows[64].postMessage.mock.lastCall?.[0]).toMatchObject({ result: true });
		for (const { postMessage } of windows) postMessage.mockClear();
		conversation.broadcast("grown", grown);
		expect(windows.map(({ postMessage }) => postMessage.mock.calls.length)).toEqual(
			windows.map((_, i) => (i === 1 ? 0 : 1)),
		);
	});

	it.each([Number.NaN, Number.POSITIVE_INFINITY, "x".repeat(201), null, {}])(
		"is ignored with the id %s",
		async (id) => {
			expect((await answersTo({ id, method: "grow" })).answers).toEqual([]);
			expect(plant.grow).not.toHaveBeenCalled();
		},
	);

	it("is ignored if it is no message of the protocol; no message throws", () =>
		fc.assert(
			fc.asyncProperty(fc.anything(), fc.anything(), async (data, values) => {
				source.postMessage.mockReset();
				const conversation = new Conversation(plant as unknown as EmbeddedPlant);
				await conversation.receive({ data, origin: HOST, source });
				expect(source.postMessage).not.toHaveBeenCalled();
				const ours = { panicle: PROTOCOL, id: 1, method: "set", values };
				await conversation.receive({ data: ours, origin: HOST, source });
				expect(source.postMessage).toHaveBeenCalledOnce();
			}),
		));
});

describe("a frame’s address", () => {
	it("holds a link, attributes of the element and allowed origins", () => {
		const search = "?v=2&preset=merlot&autorotate=&theme=dark&allow=https://a.example,https://b.example";
		expect(frameSettings({ search, hash: "#g=x" })).toEqual({
			link: "?v=2&preset=merlot#g=x",
			attributes: [
				["autorotate", ""],
				["theme", "dark"],
			],
			allowed: ["https://a.example", "https://b.example"],
		});
		expect(frameSettings({ search: "", hash: "" })).toEqual({ link: "?", attributes: [], allowed: undefined });
		// Addresses are normalised to origins; an invalid address allows no origin.
		expect(frameSettings({ search: "?allow=https://A.example:443/page", hash: "" }).allowed).toEqual([
			"https://a.example",
		]);
		expect(frameSettings({ search: "?allow=", hash: "" }).allowed).toEqual([]);
	});

	it("has keys that no link has", async () => {
		for (const model of await Promise.all(modelNames().map(modelNamed)))
			expect([...FRAME_KEYS, "allow"].filter((key) => isKnown(model, key))).toEqual([]);
	});
});
