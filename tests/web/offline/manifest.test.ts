import { readFileSync } from "node:fs";
import { expect, it } from "vitest";

const read = (path: string) => readFileSync(new URL(`../../../public/${path}`, import.meta.url));
const manifest = JSON.parse(read("panicle.webmanifest").toString());

interface Icon {
	readonly src: string;
	readonly sizes: string;
	readonly purpose?: string;
}

it("installs from any sub-path", () => {
	expect(manifest).toMatchObject({ start_url: "./", scope: "./", display: "standalone" });
	expect(manifest.icons.map(({ src }: Icon) => src)).not.toContainEqual(expect.stringMatching(/^\/|:/));
});

it("has icons of the sizes that it says, for round screens too", () => {
	const pictures = (manifest.icons as Icon[]).filter(({ src }) => src.endsWith(".png"));
	for (const { src, sizes } of pictures) {
		const header = read(src);
		expect(`${header.readUInt32BE(16)}x${header.readUInt32BE(20)}`, src).toBe(sizes);
	}
	const sizesFor = (purpose?: string) => pictures.filter((icon) => icon.purpose === purpose).map(({ sizes }) => sizes);
	expect(sizesFor()).toEqual(["192x192", "512x512"]);
	expect(sizesFor("maskable")).toEqual(["192x192", "512x512"]);
});
