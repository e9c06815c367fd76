# The module for Perl, against what follows from the page and the force law.
use strict;
use warnings;
use utf8;

BEGIN {
  unless (eval { require FFI::Platypus; 1 }) {
    print "skipped: perl has no FFI::Platypus: apt install libffi-platypus-perl\n";
    exit 77;
  }
}
use File::Temp;
use Moontrace;
use Test::More;

my $page = Moontrace->page('moon', sheet => 'a5');
is join(' ', map { $_->{sign} } $page->letters), 'm o o n', 'letters of the text';
my ($first) = $page->letters;
cmp_ok abs($first->{x} - 0.015), '<', 1e-12, 'the margin of A5';
cmp_ok abs($first->{y} - (0.210 - 0.015 - 0.012)), '<', 1e-12, 'an em below the margin';
cmp_ok abs($page->facts->{width} - 0.148), '<', 1e-12, 'A5';

# an I, 20 mm high: its groove 0.1165 em wide is half as deep; a slope of about 1 between points
# 0.1 mm apart
my $i = Moontrace->page('i', sheet => '60x50', letter_size => 0.020);
my ($letter) = $i->letters;
my $deepest = 0;
for my $step (0 .. 200) {
  my ($height) = $i->sample($letter->{x} + 0.0001 * $step, $letter->{y} + 0.010);
  $deepest = $height if $height < $deepest;
}
cmp_ok abs($deepest + 0.5 * 0.1165 * 0.020), '<', 0.00005, 'the depth of the groove';
cmp_ok abs(($i->force(0.001, 0.001, -0.0005))[2] - 0.5), '<', 1e-12, 'flat paper: 1000 N/m';
cmp_ok $i->facts->{greatest_rise}, '==', 0, 'engraved';
cmp_ok(Moontrace->page('i', embossed => 1)->facts->{greatest_rise}, '>', 0, 'embossed');
my ($accented) = Moontrace->page('é')->letters;
is $accented->{sign}, 'e', 'without its accent';
is $accented->{source_end}, 2, 'in bytes';

my $folder = File::Temp->newdir;
$i->draw("$folder/i.svg", letters => 1);
ok -s "$folder/i.svg", 'a picture';

for my $refused ([sub { $i->sample('nan', 0) }, qr/x is not a finite number/],
                 [sub { Moontrace->page('moon', script => 'mooon') }, qr/moon/],
                 [sub { Moontrace->page('moon', page => 7) }, qr/no page 7/],
                 [sub { Moontrace->page('moon', colour => 'blue') }, qr/no such setting: colour/],
                 [sub { $i->draw('/no/such/folder/i.svg') }, qr{/no/such/folder}]) {
  ok !eval { $refused->[0]->(); 1 }, 'refused';
  like $@, $refused->[1], 'and says why';
}
done_testing;
