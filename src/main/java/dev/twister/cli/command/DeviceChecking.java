package dev.twister.cli.command;

import dev.twister.bench.device.CheckedEngine;
import dev.twister.bench.device.CheckedScene;
import dev.twister.bench.device.DeviceCheck;
import dev.twister.bench.device.DeviceCheckJson;
import dev.twister.bench.device.DeviceCheckPlan;
import dev.twister.bench.device.DeviceCheckTable;
import dev.twister.cli.file.OutputFile;
import dev.twister.cli.file.SceneFiles;
import dev.twister.cli.file.SkyFiles;
import dev.twister.cli.progress.BenchmarkLine.BenchmarkBar;
import dev.twister.cli.progress.ProgressLine;
import dev.twister.engine.EngineOffer;
import dev.twister.scene.Scene;
import dev.twister.scene.format.SceneReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** {@code twister devices --check}: a table of engines, a row as soon as each is done. */
record DeviceChecking(DeviceCheckPlan plan, PrintWriter out, PrintWriter err) {
    private static final String TIMED_SCENE = "benchmark";

    /**
     * Checks the engines in all shipped scenes.
     *
     * @return whether all that work here drew what they must
     */
    boolean run(List<EngineOffer> offers, Optional<Path> json) throws IOException {
        if (json.isPresent()) {
            OutputFile.checkText("--json", json.get());
        }
        List<CheckedScene> scenes = new ArrayList<>();
        for (String name : SceneFiles.shipped()) {
            scenes.add(read(name));
        }
        CheckedScene timed = read(TIMED_SCENE);
        DeviceCheckTable table = new DeviceCheckTable(plan, offers);
        out.println(table.heading(scenes, timed));
        DeviceCheck check = new DeviceCheck(plan, scenes, timed);
        List<CheckedEngine> checked = new ArrayList<>();
        for (EngineOffer offer : offers) {
            CheckedEngine engine = check(check, offer, scenes.size());
            out.println(table.row(engine));
            checked.add(engine);
        }
        if (json.isPresent()) {
            DeviceCheckJson.write(plan, checked, json.get());
        }
        return checked.stream().allMatch(CheckedEngine::passed);
    }

    private CheckedEngine check(DeviceCheck check, EngineOffer offer, int scenes) {
        try (ProgressLine line = ProgressLine.start(err, "check", plan.framesEach(scenes))) {
            return check.check(offer, new BenchmarkBar(line));
        }
    }

    private CheckedScene read(String name) {
        Scene scene = SceneReader.read(SceneFiles.find(name));
        return new CheckedScene(name, SkyFiles.world(scene, err));
    }
}
