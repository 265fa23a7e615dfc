import { mergeConfig, type Plugin, type UserConfig } from "vite";
import base from "../../vite.config";

/** The checkout's configuration of Vite without the plugin that builds the core: a copy has its modules from the checkout. */
const { plugins, ...rest } = base as Omit<UserConfig, "plugins"> & { plugins: Plugin[] };

export default mergeConfig(rest, { plugins: plugins.filter(({ name }) => name !== "core") });
