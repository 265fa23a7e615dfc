using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEngine;

namespace Panicle.Editor
{
    /// <summary>
    /// Makes a prefab beside each imported GLB that is a game tree: `Oak.glb` gives `Oak.prefab`. glTFast imports the GLB
    /// itself, so the work is done after the import of all assets.
    /// </summary>
    public sealed class TreeImporter : AssetPostprocessor
    {
        static void OnPostprocessAllAssets(string[] imported, string[] deleted, string[] moved, string[] movedFrom)
        {
            foreach (var path in imported.Where(each => each.EndsWith(".glb", System.StringComparison.OrdinalIgnoreCase)))
            {
                // glTFast makes an object for each scene of a file; the one with all levels is not the first.
                var source = AssetDatabase.LoadAllAssetsAtPath(path).OfType<GameObject>()
                    .OrderByDescending(each => GameTree.LevelsOf(each).Count)
                    .FirstOrDefault();
                if (source != null && GameTree.LevelsOf(source).Count > 0) MakePrefab(source, path);
            }
        }

        static void MakePrefab(GameObject source, string path)
        {
            var target = Path.ChangeExtension(path, ".prefab");
            var instance = Object.Instantiate(source);
            instance.name = Path.GetFileNameWithoutExtension(path);
            try
            {
                var description = Describe(path);
                var impostor = description == null ? null : ImpostorMaterial(path, description.impostor);
                var materials = new List<Material>();
                GameTree.SetUp(instance, impostor, description, materials);
                RemoveOldParts(target);
                PrefabUtility.SaveAsPrefabAsset(instance, target);
                // Materials and the impostor's mesh are stored in the prefab.
                foreach (var material in materials) AssetDatabase.AddObjectToAsset(material, target);
                if (impostor != null) AssetDatabase.AddObjectToAsset(impostor, target);
                foreach (var filter in instance.GetComponentsInChildren<MeshFilter>(true))
                    if (!AssetDatabase.Contains(filter.sharedMesh)) AssetDatabase.AddObjectToAsset(filter.sharedMesh, target);
                PrefabUtility.SaveAsPrefabAsset(instance, target);
            }
            finally
            {
                Object.DestroyImmediate(instance);
            }
        }

        /// <summary>Removes the materials and meshes that an earlier import stored in a prefab.</summary>
        static void RemoveOldParts(string target)
        {
            foreach (var part in AssetDatabase.LoadAllAssetRepresentationsAtPath(target))
                if (part is Material || part is Mesh) Object.DestroyImmediate(part, true);
        }

        /// <summary>Returns the JSON beside a GLB, or null.</summary>
        static TreeDescription Describe(string path)
        {
            var file = Path.ChangeExtension(path, ".json");
            return File.Exists(file) ? JsonUtility.FromJson<TreeDescription>(File.ReadAllText(file)) : null;
        }

        /// <summary>Returns the material of an impostor, or null, with a warning, if a picture is missing.</summary>
        static Material ImpostorMaterial(string path, ImpostorDescription description)
        {
            // JsonUtility makes an empty object where the JSON has none.
            if (description == null || description.frames < 2 || description.middle == null) return null;
            var folder = Path.GetDirectoryName(path);
            var colour = AssetDatabase.LoadAssetAtPath<Texture2D>(Path.Combine(folder, description.colour));
            var surface = AssetDatabase.LoadAssetAtPath<Texture2D>(Path.Combine(folder, description.surface));
            if (colour == null || surface == null)
            {
                Debug.LogWarning(path + ": a picture of the impostor is missing. Copy all files of the archive, and import the GLB again.");
                return null;
            }
            var material = new Material(Shader.Find("Panicle/Impostor")) { name = "Impostor", enableInstancing = true };
            material.SetTexture("_BaseMap", colour);
            material.SetTexture("_SurfaceMap", surface);
            return material;
        }
    }
}
