# Contact and wear of elastic bodies: the program, with completions and manual pages.
class Archard < Formula
  desc "Contact and wear of elastic bodies, from a case file to worn profiles"
  # Placeholders until the first release is published.
  homepage "https://example.org/archard"
  url "https://example.org/archard/releases/download/v0.1.0/archard-0.1.0-source.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000"
  license any_of: ["MIT", "Apache-2.0"]

  depends_on "rust" => :build

  def install
    system "cargo", "install", "--profile", "dist", "--features", "pdf", *std_cargo_args(path: "crates/archard-cli")
    generate_completions_from_executable(bin/"archard", "completions")
    system bin/"archard", "man", "man"
    man1.install Dir["man/*.1"]
  end

  test do
    system bin/"archard", "doctor"
    system bin/"archard", "run", "pin_on_disc", "--output", "out"
    assert_path_exists testpath/"out/history.csv"
  end
end
