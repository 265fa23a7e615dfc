/** `npm run package`: makes build/package/panicle-VERSION.tgz, the library for npm, and prints its path. */
import { makePackage } from "./package/make.mjs";
import { command, setUp } from "./setup.mjs";

await command(async () => {
	await setUp("core");
	const { tarball } = await makePackage();
	console.log(tarball);
});
