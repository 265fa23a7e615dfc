/** What every command does first. Runs on a clean clone: nothing here may import a package. */
import { CoreBuildError } from "./core.mjs";
import { generateCode } from "./generate/files.mjs";
import { ensurePackages } from "./npm_packages.mjs";
import { isOlder } from "./packages.mjs";
import { prepare, ToolchainError } from "./toolchain.mjs";

const oldestNode = "20.19";

function checkNode() {
	if (!isOlder(process.versions.node, oldestNode)) return;
	throw new ToolchainError(
		`Panicle needs Node ${oldestNode} or newer; this is ${process.versions.node}. See nodejs.org.`,
	);
}

/**
 * Checks Node, generates code, finds the tools that `purpose` needs and installs the npm packages. Returns the tools' paths.
 *
 * @param {string} purpose
 * @param {{ meanwhile?: () => Promise<void> }} [options] meanwhile: work that needs the tools but no npm package; runs while these are installed
 */
export async function setUp(purpose, { meanwhile = async () => {} } = {}) {
	checkNode();
	generateCode();
	const tools = await prepare(purpose);
	await Promise.all([ensurePackages(), meanwhile()]);
	return tools;
}

/** Runs a command; a problem that the user can fix ends it with its message, without a stack, and status 1. */
export async function command(work) {
	try {
		await work();
	} catch (error) {
		if (!(error instanceof ToolchainError || error instanceof CoreBuildError)) throw error;
		console.error(error.message);
		process.exit(1);
	}
}
