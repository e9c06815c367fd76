#!/usr/bin/perl
# A program of somebody else in Perl: the letters of a text, and what a tip feels on the paper.
use strict;
use warnings;
use Moontrace;

my $page = Moontrace->page('moon');
printf "%s at %.1f mm\n", $_->{sign}, 1000 * $_->{x} for $page->letters;
my ($x, $y, $z) = $page->force(0.001, 0.001, -0.0005);
printf "%.2f N on flat paper\n", $z;
