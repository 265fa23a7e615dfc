import { chmodSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { find, missingPackages, prepareBrowsers } from "../browsers/browsers.mjs";

let machine: string;
let env: NodeJS.ProcessEnv;

beforeEach(() => {
	machine = mkdtempSync(join(tmpdir(), "browsers-"));
	env = { PATH: machine, MESA: machine };
});
afterEach(() => rmSync(machine, { recursive: true }));

/** Puts programs on the simulated machine. */
function have(...names: string[]): void {
	mkdirSync(machine, { recursive: true });
	for (const name of names) {
		writeFileSync(join(machine, name), "");
		chmodSync(join(machine, name), 0o755);
	}
}

const SCREEN = ["Xvfb", "libEGL_mesa.so.0"];
const quiet = () => {};
const never = () => Promise.reject(new Error("nothing needs to be installed"));

describe("browsers besides Chromium", () => {
	it("are used as they are on the machine", async () => {
		have("firefox-esr", "firefox", "WebKitWebDriver", ...SCREEN);
		expect(await prepareBrowsers({ env, install: never })).toEqual({ there: ["firefox", "webkit"], without: [] });
		expect(find("firefox", env)).toBe(join(machine, "firefox-esr"));
	});

	it("are installed in one call of apt, with a screen and Mesa", async () => {
		have("apt-get");
		const calls: string[][] = [];
		const install = async (packages: string[]) => {
			calls.push(packages);
			have("firefox-esr", "WebKitWebDriver", ...SCREEN);
			return null;
		};
		expect(await prepareBrowsers({ env, install, log: quiet })).toEqual({ there: ["firefox", "webkit"], without: [] });
		expect(calls).toEqual([["firefox-esr", "xvfb", "libegl1", "libgl1-mesa-dri", "webkit2gtk-driver"]]);
		expect(missingPackages(env)).toEqual([]);
	});

	it("are installed each by itself if apt does not install all of them", async () => {
		have("apt-get", "firefox-esr");
		const calls: string[][] = [];
		const install = async (packages: string[]) => {
			calls.push(packages);
			if (packages.includes("webkit2gtk-driver")) return { why: "and it is unknown", unfit: packages };
			have(...SCREEN);
			return null;
		};
		expect(await prepareBrowsers({ env, install, log: quiet })).toEqual({
			there: ["firefox"],
			without: ["WebKit is not tested: it is not there and it is unknown."],
		});
		const shared = ["xvfb", "libegl1", "libgl1-mesa-dri"];
		expect(calls).toEqual([[...shared, "webkit2gtk-driver"], shared, ["webkit2gtk-driver"]]);
	});

	it("are named with what they lack where there is no apt, and the tests use the others", async () => {
		have("WebKitWebDriver", ...SCREEN);
		expect(await prepareBrowsers({ env, install: never })).toEqual({
			there: ["webkit"],
			without: ["Firefox is not tested: this machine lacks firefox-esr."],
		});
		expect(() => find("firefox", env)).toThrow("npm test -- browsers");
	});
});
