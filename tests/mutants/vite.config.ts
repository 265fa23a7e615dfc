import { mergeConfig, type Plugin, type UserConfig } from "vite";
import base from "../../vite.config";

/** The checkout's own settings, less what would build the core: a copy has its modules from the checkout. */
const { plugins, test, ...rest } = base as Omit<UserConfig, "plugins"> & {
	plugins: Plugin[];
	test: Record<string, unknown>;
};
const { globalSetup: _, ...settings } = test;

export default mergeConfig(rest, {
	plugins: plugins.filter(({ name }) => name !== "core"),
	test: { ...settings, bail: 1 },
});
