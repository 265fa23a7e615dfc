/** All faults, in the order of the house. @type {import("../mutants.mjs").Group[]} */
import baked from "./baked.mjs";
import boundary from "./boundary.mjs";
import bounds from "./bounds.mjs";
import browsers from "./browsers.mjs";
import bunchCore from "./bunch_core.mjs";
import bunchCrop from "./bunch_crop.mjs";
import bunchExport from "./bunch_export.mjs";
import bunchRenderer from "./bunch_figure.mjs";
import bunchIndividual from "./bunch_individual.mjs";
import bunchMeasures from "./bunch_measures.mjs";
import bunchNatural from "./bunch_natural.mjs";
import bunchProfile from "./bunch_profile.mjs";
import bunchRipening from "./bunch_ripening.mjs";
import bunchSurfaces from "./bunch_surfaces.mjs";
import docs from "./docs.mjs";
import embed from "./embed.mjs";
import exporting from "./export.mjs";
import files from "./files.mjs";
import flower from "./flower.mjs";
import flowerDesign from "./flower_design.mjs";
import flowerLevels from "./flower_levels.mjs";
import flowerPage from "./flower_page.mjs";
import flowerText from "./flower_text.mjs";
import generalizedMap from "./generalized_map.mjs";
import gestures from "./gestures.mjs";
import grammar from "./grammar.mjs";
import grammarEditor from "./grammar_editor.mjs";
import growth from "./growth.mjs";
import growthShape from "./growth_shape.mjs";
import handles from "./handles.mjs";
import leaf from "./leaf.mjs";
import leafPictures from "./leaf_pictures.mjs";
import library from "./library.mjs";
import light from "./light.mjs";
import lives from "./lives.mjs";
import lsystem from "./lsystem.mjs";
import offline from "./offline.mjs";
import page from "./page.mjs";
import particles from "./particles.mjs";
import randomUse from "./random_use.mjs";
import rooms from "./rooms.mjs";
import saved from "./saved.mjs";
import scene from "./scene.mjs";
import series from "./series.mjs";
import service from "./service.mjs";
import specimen from "./specimen.mjs";
import stand from "./stand.mjs";
import standBed from "./stand_bed.mjs";
import standCrowd from "./stand_crowd.mjs";
import standTrellis from "./stand_trellis.mjs";
import stepper from "./stepper.mjs";
import studio from "./studio.mjs";
import studioView from "./studio_view.mjs";
import swelling from "./swelling.mjs";
import targets from "./targets.mjs";
import topiary from "./topiary.mjs";
import webCore from "./web_core.mjs";
import wind from "./wind.mjs";
import wood from "./wood.mjs";

export const groups = [
	...randomUse,
	...rooms,
	...generalizedMap,
	...lsystem,
	...grammar,
	...particles,
	...wood,
	...leaf,
	...leafPictures,
	...boundary,
	...bounds,
	...bunchCore,
	...bunchCrop,
	...bunchNatural,
	...swelling,
	...targets,
	...series,
	...library,
	...service,
	...docs,
	...bunchRipening,
	...bunchSurfaces,
	...bunchIndividual,
	...bunchMeasures,
	...topiary,
	...webCore,
	...specimen,
	...handles,
	...gestures,
	...bunchProfile,
	...bunchExport,
	...exporting,
	...baked,
	...bunchRenderer,
	...saved,
	...scene,
	...wind,
	...lives,
	...grammarEditor,
	...flower,
	...flowerDesign,
	...flowerLevels,
	...flowerPage,
	...flowerText,
	...growth,
	...stand,
	...standBed,
	...standCrowd,
	...standTrellis,
	...growthShape,
	...stepper,
	...studio,
	...studioView,
	...offline,
	...files,
	...embed,
	...light,
	...page,
	...browsers,
];
