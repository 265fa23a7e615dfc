/** The distribution's packages: which manager there is, and installing where that needs no question. */
import { accessSync, constants } from "node:fs";
import { delimiter, join } from "node:path";
import { capture, run } from "./process.mjs";

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

/** The package manager of this machine; null when it has none that we know. */
export function packageManager(env) {
	return managers.find(({ name }) => onPath(name, env)) ?? null;
}

/**
 * Installs packages without asking anyone. Returns null, or why it could not be done, as the end of a sentence.
 * The whole installation is rehearsed first, so that one package too few leaves nothing behind.
 */
export async function installWithApt(packages, env) {
	if (!isRoot() && capture("sudo", ["-n", "true"], env) === null) {
		return "and installing needs an administrator's rights";
	}
	const prefix = isRoot() ? ["env"] : ["sudo", "-n", "env"];
	const apt = (args, show) =>
		run(prefix[0], [...prefix.slice(1), "DEBIAN_FRONTEND=noninteractive", "apt-get", "-q", ...args], { env, show });
	const install = ["install", "-y", "--no-install-recommends", ...packages];
	await apt(["update"]);
	const rehearsal = await apt(["--simulate", ...install]);
	if (rehearsal.status !== 0) {
		const reason = /^E: (.*)$/m.exec(rehearsal.output)?.[1] ?? "apt-get failed";
		return `and its packages do not install (${reason.replace(/\.$/, "")})`;
	}
	const { status, output } = await apt(install, process.stderr);
	if (status === 0) return null;
	return `and its packages did not install (${/^E: (.*)$/m.exec(output)?.[1] ?? `apt-get ended with ${status}`})`;
}
