cask "twister" do
  arch arm: "aarch64", intel: "x64"

  version "@version@"
  sha256 arm:   "@sha256:twister-@version@-macos-aarch64.dmg@",
         intel: "@sha256:twister-@version@-macos-x64.dmg@"

  url "https://github.com/@repository@/releases/download/v#{version}/twister-#{version}-macos-#{arch}.dmg"
  name "Twister"
  desc "Real-time ray tracer"
  homepage "https://github.com/@repository@"

  app "twister.app"
  binary "#{appdir}/twister.app/Contents/app/scripts/twister"
end
