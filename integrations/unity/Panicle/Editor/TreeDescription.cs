using System;

namespace Panicle.Editor
{
    /// <summary>The JSON beside the GLB of a game tree, as JsonUtility reads it.</summary>
    [Serializable]
    public sealed class TreeDescription
    {
        /// <summary>The levels, the finest first.</summary>
        public LevelDescription[] levels;

        /// <summary>The pictures of the tree for large distances.</summary>
        public ImpostorDescription impostor;
    }

    /// <summary>A level of detail.</summary>
    [Serializable]
    public sealed class LevelDescription
    {
        /// <summary>The least share of the view's area at which it is drawn.</summary>
        public float screenCoverage;
    }

    /// <summary>The impostor: pictures of the tree from a hemisphere of directions, in a square grid.</summary>
    [Serializable]
    public sealed class ImpostorDescription
    {
        /// <summary>Pictures along an edge of the grid.</summary>
        public int frames;

        /// <summary>The middle of all pictures in metres, +Y up, right-handed as in glTF.</summary>
        public float[] middle;

        /// <summary>Half the edge of a picture, metres.</summary>
        public float radius;

        /// <summary>The file with colour and coverage.</summary>
        public string colour;

        /// <summary>The file with normals and depth.</summary>
        public string surface;
    }
}
