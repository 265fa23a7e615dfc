import fc from "fast-check";
import { describe, expect, it } from "vitest";
import {
	EMBED_FORMS,
	type EmbedChoice,
	embedCode,
	frameAddress,
	MODEL_VIEWER,
} from "../../../web/src/app/files/embed_code";
import { OWN_ATTRIBUTES } from "../../../web/src/element/attributes";
import { FRAME_KEYS, frameSettings } from "../../../web/src/element/embed/frame_settings";

const of = {
	app: "https://plants.example/app/",
	link: "?v=2&preset=riesling&p3=80,76#g=Ab-_9",
	description: "“Riesling” bunch: 99 berries",
	file: "riesling-7.glb",
};
const choice: EmbedChoice = {
	form: "element",
	width: 320,
	height: 480,
	autorotate: false,
	wind: false,
	controls: false,
	handles: false,
	lazy: false,
};

/** Tags with their attributes as a browser has them. */
function tagsOf(html: string) {
	const plain = (text: string) => text.replaceAll("&quot;", '"').replaceAll("&lt;", "<").replaceAll("&amp;", "&");
	return [...html.matchAll(/<([a-z-]+)((?: [a-z-]+(?:="[^"<]*")?)*)>/g)].map(([, tag, rest]) => ({
		tag,
		...Object.fromEntries(
			[...rest.matchAll(/ ([a-z-]+)(?:="([^"]*)")?/g)].map(([, key, value = ""]) => [key, plain(value)]),
		),
	}));
}

describe("embed code", () => {
	it("is one script and one tag with the whole link", () => {
		expect(tagsOf(embedCode(of, choice))).toEqual([
			{ tag: "script", type: "module", src: "https://plants.example/app/panicle.js" },
			{ tag: "panicle-specimen", link: of.link, style: "display: block; width: 320px; max-width: 100%; height: 480px" },
		]);
	});

	it("is a frame, with its keys before the link’s fragment", () => {
		const [frame, ...others] = tagsOf(
			embedCode(of, { ...choice, form: "frame", wind: true, controls: true, lazy: true }),
		);
		expect(others).toEqual([]);
		expect(frame).toMatchObject({ tag: "iframe", title: of.description, width: "320", height: "480", loading: "lazy" });
		const { search, hash } = new URL((frame as unknown as { src: string }).src);
		expect(frameSettings({ search, hash })).toEqual({
			link: "?v=2&preset=riesling&p3=80%2C76#g=Ab-_9",
			attributes: [
				["wind", ""],
				["controls", ""],
			],
			allowed: undefined,
		});
	});

	it("is model-viewer with a file beside the page", () => {
		expect(tagsOf(embedCode(of, { ...choice, form: "model-viewer", controls: true, autorotate: true }))).toEqual([
			{ tag: "script", type: "module", src: MODEL_VIEWER },
			expect.objectContaining({
				tag: "model-viewer",
				src: of.file,
				alt: of.description,
				"camera-controls": "",
				"auto-rotate": "",
			}),
		]);
	});

	it("contains each option by the names of the element and the frame", () => {
		for (const key of ["autorotate", "controls", "handles"] as const) {
			expect(OWN_ATTRIBUTES).toContain(key);
			expect(FRAME_KEYS).toContain(key);
			expect(tagsOf(embedCode(of, { ...choice, [key]: true }))[1]).toHaveProperty(key, "");
			expect(frameAddress(of, { [key]: true })).toContain(`&${key}=#`);
		}
		for (const form of EMBED_FORMS)
			expect(tagsOf(embedCode(of, { ...choice, form, lazy: true })).at(-1)).toHaveProperty("loading", "lazy");
	});

	it("escapes all texts in attributes", () =>
		fc.assert(
			fc.property(
				fc.constantFrom(...EMBED_FORMS),
				fc.string({ unit: fc.constantFrom(..."\"'<>&= a/") }),
				(form, text) => {
					const before = tagsOf(embedCode({ ...of, description: "", file: "a" }, { ...choice, form }));
					const html = embedCode(
						{ ...of, link: `?a=${text}`, description: text, file: `a${text}` },
						{ ...choice, form },
					);
					const after = tagsOf(html);
					expect(after.map((tag) => Object.keys(tag))).toEqual(before.map((tag) => Object.keys(tag)));
					if (form === "element") expect(after[1]).toHaveProperty("link", `?a=${text}`);
					if (form === "frame") expect(after[0]).toHaveProperty("title", text);
				},
			),
		));
});
