/** Programs that run as long as a test does. */
import { type ChildProcess, spawn } from "node:child_process";

/** Longest wait for a program's start, milliseconds. */
const PATIENCE = 60_000;

/** A started program: its matched output, and its end. */
export interface Started {
	/** The first group of the pattern that was waited for. */
	readonly output: string;
	end(): Promise<void>;
}

/**
 * Starts a program and waits until its output, or its third channel, matches a pattern with a group. Without a pattern
 * it does not wait.
 * @throws when the program ends first, or writes no match within a minute
 */
export async function start(
	command: string,
	args: readonly string[],
	output: RegExp | undefined,
	env: NodeJS.ProcessEnv = process.env,
): Promise<Started> {
	// A group of its own: browsers are many processes, and all of them go.
	const child = spawn(command, args, { env, stdio: ["ignore", "pipe", "pipe", "pipe"], detached: true });
	const gone = new Promise<void>((resolve) => child.once("close", () => resolve()));
	const kill = () => endGroup(child.pid);
	process.once("exit", kill);
	const end = async () => {
		kill();
		await gone;
		process.off("exit", kill);
	};
	try {
		return { output: await heard(child, command, output), end };
	} catch (error) {
		await end();
		throw error;
	}
}

function endGroup(leader: number | undefined): void {
	if (leader === undefined) return;
	try {
		process.kill(-leader, "SIGKILL");
	} catch {
		// It went by itself in the meantime.
	}
}

function heard(child: ChildProcess, command: string, pattern: RegExp | undefined): Promise<string> {
	return new Promise((resolve, reject) => {
		let text = "";
		const late = setTimeout(() => reject(new Error(`${command} did not start: ${text}`)), PATIENCE);
		const settle = (result: () => void) => {
			clearTimeout(late);
			result();
		};
		for (const stream of [child.stdout, child.stderr, child.stdio[3]]) {
			stream?.on("data", (piece) => {
				text += piece;
				const [, found] = pattern?.exec(text) ?? [];
				if (found !== undefined) settle(() => resolve(found));
			});
		}
		if (!pattern) child.once("spawn", () => settle(() => resolve("")));
		child.once("error", (error) => settle(() => reject(error)));
		child.once("exit", () => settle(() => reject(new Error(`${command} ended: ${text}`))));
	});
}

/** A virtual screen for browsers that need one; the program's output is its name. */
export async function startScreen(): Promise<Started & { readonly display: string }> {
	const size = "1440x900x24";
	const args = ["-displayfd", "3", "-screen", "0", size, "-nolisten", "tcp"];
	const screen = await start("Xvfb", args, /^(\d+)\n/m);
	return { ...screen, display: `:${screen.output}` };
}
