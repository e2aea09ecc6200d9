package dev.twister.engine.vector.crowd;

/** One thread's working memory for traversals of the hierarchy. */
public final class TraversalMemory {
    /** Around all of a tile's rays, one packet's, or a single ray. */
    public final Beam beam = new Beam();

    /** One beam per lane, around a ray or its lines to the light. */
    public final PacketBeams packetBeams = new PacketBeams();

    public final Leaves leaves = new Leaves();
    public final PacketLeaves packetLeaves = new PacketLeaves();
    public final BeamStack descent = new BeamStack();
    final RaySpheres raySpheres = new RaySpheres();
    final EntryNodes entrance = new EntryNodes();

    /** The leaf reached by a single ray, with the ray's number above. */
    final int[] leafMet = new int[1];
}
