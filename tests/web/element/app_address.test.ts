import { afterEach, describe, expect, it, vi } from "vitest";

async function addressIn(mode: string, said: string | null): Promise<string | undefined> {
	vi.stubEnv("MODE", mode);
	vi.stubGlobal("document", { baseURI: "https://a.page/course/" });
	vi.resetModules();
	return (await import("../../../web/src/element/app_address")).appAddress(said);
}

afterEach(() => {
	vi.unstubAllEnvs();
	vi.unstubAllGlobals();
});

describe("where Open in the app leads", () => {
	it("is the folder that built scripts lie in a folder of", async () => {
		expect(await addressIn("production", null)).toMatch(/\/web\/src\/$/);
		expect(await addressIn("production", "../other/")).toMatch(/\/web\/other\/$/);
	});

	it("is nowhere for the package's element, beside which no app lies", async () => {
		expect(await addressIn("package", null)).toBeUndefined();
		expect(await addressIn("package", "../app/")).toBe("https://a.page/app/");
	});

	it("is nowhere where that is what a page says, or says what is no address", async () => {
		for (const mode of ["production", "package"]) {
			expect(await addressIn(mode, "")).toBeUndefined();
			expect(await addressIn(mode, "https://")).toBeUndefined();
		}
	});
});
