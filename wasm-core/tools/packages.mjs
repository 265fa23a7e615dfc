/** Finds the distribution's package manager, and installs packages where that needs no confirmation. */
import { accessSync, constants } from "node:fs";
import { delimiter, join } from "node:path";
import { capture, run } from "./process.mjs";

/** Returns whether a folder of PATH has an executable file of that name. */
function onPath(program, env) {
	return (env.PATH ?? "")
		.split(delimiter)
		.filter(Boolean)
		.some((folder) => {
			try {
				accessSync(join(folder, program), constants.X_OK);
				return true;
			} catch {
				return false;
			}
		});
}

const isRoot = () => process.getuid?.() === 0;
const sudo = () => (isRoot() ? "" : "sudo ");

/** Package managers and the commands that a person would type. */
const managers = [
	{
		name: "apt-get",
		commands: (packages) => [`${sudo()}apt-get update`, `${sudo()}apt-get install -y ${packages.join(" ")}`],
	},
	{ name: "dnf", commands: (packages) => [`${sudo()}dnf install -y ${packages.join(" ")}`] },
	{ name: "pacman", commands: (packages) => [`${sudo()}pacman -S --needed ${packages.join(" ")}`] },
	{
		name: "brew",
		commands: (packages) => {
			const casks = packages.filter((name) => name.startsWith("--cask"));
			const formulae = packages.filter((name) => !name.startsWith("--cask"));
			const plain = formulae.length > 0 ? [`brew install ${formulae.join(" ")}`] : [];
			return [...plain, ...casks.map((cask) => `brew install ${cask}`)];
		},
	},
];

/** The package manager of this machine; null if it has none of these. */
export function packageManager(env) {
	return managers.find(({ name }) => onPath(name, env)) ?? null;
}

/** Whether version `a`, as in 3.1.69, comes before `b`. */
export function isOlder(a, b) {
	const [x, y] = [a, b].map((version) => version.split(".").map((part) => Number.parseInt(part, 10)));
	for (let i = 0; i < Math.max(x.length, y.length); i++) {
		if ((x[i] ?? 0) !== (y[i] ?? 0)) return (x[i] ?? 0) < (y[i] ?? 0);
	}
	return false;
}

/**
 * Reads a dry run of apt-get: the reason why it would not install, and the packages that this distribution cannot provide, those
 * that it does not know and those older than in `oldest`. Null where everything can be installed.
 *
 * @param {{ status: number, output: string }} dryRun
 * @param {Record<string, string>} oldest version by package
 * @returns {{ why: string, unfit: string[] } | null}
 */
export function objections({ status, output }, oldest) {
	const unknown = [...output.matchAll(/Unable to locate package (\S+)|Package '(\S+)' has no installation candidate/g)];
	const old = [...output.matchAll(/^Inst (\S+) (?:\[\S+\] )?\((?:\d+:)?([\d.]+)/gm)].filter(
		([, name, version]) => oldest[name] && isOlder(version, oldest[name]),
	);
	const unfit = [...unknown.map(([, a, b]) => a ?? b), ...old.map(([, name]) => name)];
	if (old.length > 0) {
		const offers = old.map(([, name, version]) => `${name} ${version}`).join(", ");
		return { why: `and this system's packages are too old (${offers})`, unfit };
	}
	if (status === 0) return null;
	const reason = /^E: (.*?)\.?$/m.exec(output)?.[1] ?? "apt-get failed";
	return { why: `and its packages do not install (${reason})`, unfit };
}

/**
 * Installs packages without confirmation. Returns null, or the reason for a failure as the end of a sentence, with the
 * packages that cannot be used. A dry run of the whole installation comes first, so that nothing is left half-done.
 */
export async function installWithApt(packages, oldest, env) {
	if (!isRoot() && capture("sudo", ["-n", "true"], env) === null) {
		return { why: "and installing needs an administrator's rights", unfit: [] };
	}
	const prefix = isRoot() ? ["env"] : ["sudo", "-n", "env"];
	const apt = (args, show) =>
		run(prefix[0], [...prefix.slice(1), "DEBIAN_FRONTEND=noninteractive", "apt-get", "-q", ...args], { env, show });
	const install = ["install", "-y", "--no-install-recommends", ...packages];
	await apt(["update"]);
	const objection = objections(await apt(["--simulate", ...install]), oldest);
	if (objection) return objection;
	return objections(await apt(install, process.stderr), {});
}
